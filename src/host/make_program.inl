// The Program of a scene and its settings. Included by program.inl.

inline Program<RuntimeEffects> makeProgram(const PackedScene& scene, const Scene& source,
                                           const EffectSet& effects, const HostSettings& settings) {
  return {scene,
          frameConstants(source, scene.lightChoice, settings.estimator, settings.width, settings.height,
                         settings.seed),
          effects, settings.estimator.roulette, source.filter.shape, settings.estimator.sampler,
          settings.estimator.reuseEdge()};
}
