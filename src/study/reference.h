#pragma once
// What the runs of a study are held against, and how far they are from it.

#include "film/film.h"

namespace vkpt {

/// The mean squared error in its two forms; relative: see FilmStatistics.
struct SquaredError {
  double mse = 0.0;
  double relMse = 0.0;
};

/// An image that stands for the truth. Its own noise is known where it was rendered here or its file tells
/// standard errors.
class Reference {
public:
  explicit Reference(const Film& film);
  explicit Reference(const Image& image);

  [[nodiscard]] int width() const { return m_width; }
  [[nodiscard]] int height() const { return m_height; }
  /// Over the pixels that are finite.
  [[nodiscard]] const Vec3d& mean() const { return m_imageMean; }
  [[nodiscard]] const Vec3d& standardError() const { return m_imageError; }
  [[nodiscard]] bool noiseIsKnown() const { return m_noiseIsKnown; }
  /// What the reference's variance adds to every measured error; 0 where it is not known.
  [[nodiscard]] const SquaredError& noise() const { return m_noise; }
  /// As measured, with the reference's noise in it: E (a - b)^2 = error^2 + var b.
  [[nodiscard]] SquaredError measure(const Film& film) const;
  /// What measure() is to be, but for the reference's noise, by the film's own variances: where it is more,
  /// the film is biased, or its variances are too small. 0 while pixels have fewer than two samples.
  [[nodiscard]] SquaredError predict(const Film& film) const;
  /// R, G and B.
  [[nodiscard]] Image image() const;

private:
  void summarise();
  /// Mean of squaresAt(pixel) in both forms, over the pixels where they are finite.
  template<class Function>
  [[nodiscard]] SquaredError over(Function&& squaresAt) const;

  int m_width = 0;
  int m_height = 0;
  std::vector<Vec3d> m_mean;
  std::vector<Vec3d> m_variance; ///< of the means
  bool m_noiseIsKnown = true;
  double m_floor = 0.0; ///< (0.01 m)^2
  Vec3d m_imageMean{0.0};
  Vec3d m_imageError{0.0};
  SquaredError m_noise;
};

/// Beyond this share of a measured error the reference's own noise decides too much of it.
inline constexpr double kMostReferenceNoise = 0.1;

} // namespace vkpt
