// One path of a Program. Included by program.inl.

template<class P>
Replay replayWith(P& program, int x, int y, std::uint64_t sample) {
  Replay replay;
  auto path = program.samplePath(static_cast<uint>(x), static_cast<uint>(y), sample);
  for (bool goesOn = true; goesOn;) {
    ReplayStep step;
    step.bounce = path.bounce;
    step.branch = path.branch;
    step.origin = Vec3d(path.ray.o);
    step.direction = Vec3d(path.ray.d);
    step.throughput = Vec3d(path.beta);
    const auto hit = program.traceClosest(path.ray);
    step.hit = hit.triangle != P::kNoTriangle;
    if (step.hit) {
      step.distance = static_cast<double>(hit.t);
      step.triangle = hit.id;
      step.front = program.surfaceAt(hit, -path.ray.d).front;
    }
    const Vec3d before(path.L);
    goesOn = program.Li(path) || program.startAgain(path);
    step.gathered = Vec3d(path.L) - before;
    step.goesOn = goesOn;
    replay.steps.push_back(step);
  }
  replay.value = Vec3d(program.valueOf(path));
  return replay;
}
