#pragma once
// What report.html looks like and how its pictures are compared.

namespace vkpt {

inline constexpr const char* kReportStyle = R"(
body { font: 15px/1.45 sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; color: #222; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.3rem; margin-top: 2.6rem; } h3 { font-size: 1.1rem; margin-top: 2rem; }
table { border-collapse: collapse; margin: .6rem 0; }
th, td { border-bottom: 1px solid #ccc; padding: .3rem .7rem; text-align: right; vertical-align: top; }
th:first-child, td:first-child { text-align: left; }
.note { color: #555; } .remark { border-left: 4px solid #d55e00; padding-left: .7rem; }
.plot { width: 100%; max-width: 54rem; }
.pair { position: relative; display: inline-block; line-height: 0; }
.pair img { width: 32rem; max-width: 100%; image-rendering: pixelated; }
.pair img + img { position: absolute; left: 0; top: 0; }
.pair input { position: absolute; left: 0; bottom: -1.6rem; width: 100%; }
.choose { margin-top: 2.2rem; }
.row { display: flex; flex-wrap: wrap; gap: .8rem; }
figure { margin: 0; } figure img { width: 14.5rem; image-rendering: pixelated; }
figcaption { font-size: .85rem; max-width: 14.5rem; }
.scale { width: 14.5rem; height: .8rem; display: inline-block; vertical-align: middle; }
code { background: #f2f2f2; padding: 0 .2rem; }
)";

/// In each section two of the pictures one over the other, cut at the slider.
inline constexpr const char* kReportScript = R"(
for (const section of document.querySelectorAll('section.study')) {
  const sources = [...section.querySelectorAll('figure.picture')].map(f =>
    ({ name: f.querySelector('figcaption').textContent, data: f.querySelector('img').src }));
  const [under, over] = section.querySelectorAll('.pair img');
  const [left, right] = section.querySelectorAll('.choose select');
  const cut = section.querySelector('.pair input');
  if (!cut)
    continue;
  for (const select of [left, right])
    sources.forEach((s, i) => select.add(new Option(s.name, i)));
  const show = () => {
    over.src = sources[left.value].data;
    under.src = sources[right.value].data;
    over.style.clipPath = `inset(0 ${100 - cut.value}% 0 0)`;
  };
  left.value = 0;
  right.value = sources.length > 1 ? 1 : 0;
  for (const control of [left, right, cut])
    control.addEventListener('input', show);
  show();
}
)";

} // namespace vkpt
