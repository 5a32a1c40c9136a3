// Renders with a Program. Included by program.inl.

/// Every pixel, rows of blocks dealt out to threads as they come for more; no result depends on their number.
/// makeProgram: () -> Program<...>, one for each thread.
template<class MakeProgram>
HostRender renderWith(const MakeProgram& makeProgram, int width, int height, std::uint64_t frames,
                      unsigned threads) {
  HostRender render;
  render.film = {
      width, height,
      std::vector<PixelMoments>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
  SplatSums splats(width, height);
  SplatScale scale;
  bool tracesLights = false;
  std::atomic<int> nextRow{0};
  constexpr int kEdge = static_cast<int>(kBlockEdge);
  std::mutex counting;
  const auto work = [&] {
    auto program = makeProgram();
    program.splats = &splats;
    for (int row = nextRow++; row * kEdge < height; row = nextRow++) {
      for (int column = 0; column * kEdge < width; ++column)
        program.sampleBlock(static_cast<uint>(column), static_cast<uint>(row), 0, frames, render.film);
    }
    const std::scoped_lock lock(counting);
    render.counters += program.counters;
    scale = {static_cast<float>(program.splatUnits()), static_cast<float>(program.splatSquareUnits())};
    tracesLights = program.tracesLights();
  };
  if (threads <= 1) {
    work();
  } else {
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < threads; ++i)
      workers.emplace_back(work);
  } // joins
  if (tracesLights)
    splats.addTo(render.film, scale);
  return render;
}
