#include "app/assignment_pictures.h"

#include <array>

namespace vkpt {
namespace {

constexpr std::array kPicturesA{
    AssignmentPicture{"a-blocks", "A 1",
                      "The box with the blocks, colour bleeding: direct light sampled, roulette with the "
                      "diffuse reflectance",
                      512, "cornell --roulette albedo --light nee"},
    AssignmentPicture{"a-spheres", "A 2", "A silver and a glass sphere", 1024,
                      "cornell-spheres --roulette albedo --light nee"},
    AssignmentPicture{"a-primary-caustics", "A 3", "The primary caustics alone", 1024,
                      "cornell-spheres --paths caustic --light nee"},
    AssignmentPicture{"a-secondary-caustics", "A 3", "The secondary caustics alone", 1024,
                      "cornell-spheres --paths indirect-caustic --light nee --exposure 2"},
    AssignmentPicture{"a-roulette", "A 4", "Splitting against roulette: depth 0", 256,
                      "cornell-spheres --roulette albedo --light nee --split 0"},
    AssignmentPicture{"a-split-1", "A 4", "depth 1", 256,
                      "cornell-spheres --roulette albedo --light nee --split 1"},
    AssignmentPicture{"a-split-2", "A 4", "depth 2", 256,
                      "cornell-spheres --roulette albedo --light nee --split 2"},
    AssignmentPicture{"a-split-4", "A 4", "depth 4", 256,
                      "cornell-spheres --roulette albedo --light nee --split 4"},
};

constexpr std::array kPicturesB{
    AssignmentPicture{
        "b-busts", "B 4.2.1",
        "Paths of up to three edges, light area sampling; diffuse and phong (two busts in place "
        "of Ajax)",
        64, "assets/busts.xml --light nee --max-bounces 2"},
    AssignmentPicture{"b-cbox-q1.0", "B 4.2.2", "The box lit from the side, q = 1", 256,
                      "assets/cbox.xml --light nee --roulette constant=1.0 --exposure 1"},
    AssignmentPicture{"b-cbox-q0.7", "B 4.2.2", "q = 0.7", 256,
                      "assets/cbox.xml --light nee --roulette constant=0.7 --exposure 1"},
    AssignmentPicture{"b-cbox-q0.4", "B 4.2.2", "q = 0.4", 256,
                      "assets/cbox.xml --light nee --roulette constant=0.4 --exposure 1"},
    AssignmentPicture{"b-cbox-q0.1", "B 4.2.2", "q = 0.1", 256,
                      "assets/cbox.xml --light nee --roulette constant=0.1 --exposure 1"},
    AssignmentPicture{"b-own-q1.0", "B 4.2.3", "A scene of our own, equal samples, q = 1", 256,
                      "assets/q-scene.xml --light nee --roulette constant=1.0"},
    AssignmentPicture{"b-own-q0.7", "B 4.2.3", "q = 0.7", 256,
                      "assets/q-scene.xml --light nee --roulette constant=0.7"},
    AssignmentPicture{"b-own-q0.4", "B 4.2.3", "q = 0.4", 256,
                      "assets/q-scene.xml --light nee --roulette constant=0.4"},
    AssignmentPicture{"b-own-q0.1", "B 4.2.3", "q = 0.1", 256,
                      "assets/q-scene.xml --light nee --roulette constant=0.1"},
    AssignmentPicture{"b-own-time-q1.0", "B 4.2.3", "Equal time, q = 1", 0,
                      "assets/q-scene.xml --light nee --roulette constant=1.0"},
    AssignmentPicture{"b-own-time-q0.7", "B 4.2.3", "q = 0.7", 0,
                      "assets/q-scene.xml --light nee --roulette constant=0.7"},
    AssignmentPicture{"b-own-time-q0.4", "B 4.2.3", "q = 0.4", 0,
                      "assets/q-scene.xml --light nee --roulette constant=0.4"},
    AssignmentPicture{"b-own-time-q0.1", "B 4.2.3", "q = 0.1", 0,
                      "assets/q-scene.xml --light nee --roulette constant=0.1"},
    AssignmentPicture{"b-meshes", "B figure 3", "Several meshes in the box", 256,
                      "assets/cbox-meshes.xml --light nee --roulette constant=0.1"},
    AssignmentPicture{"b-meshes-mis", "B figure 3",
                      "What makes it converge faster: multiple importance sampling", 256,
                      "assets/cbox-meshes.xml --light mis"},
};

constexpr std::array kExperimentsA{
    AssignmentExperiment{"splitting-primary", "Splitting and the primary caustics",
                         "cornell-spheres --light nee --class caustic --vary split=0,1,2,4"},
    AssignmentExperiment{"splitting-secondary", "Splitting and the secondary caustics",
                         "cornell-spheres --light nee --class indirect-caustic --vary split=0,1,2,4"},
};

constexpr std::array kExperimentsB{
    AssignmentExperiment{
        "q", "q at equal samples, equal time and equal error",
        "assets/q-scene.xml --light nee --vary roulette=constant=1.0,constant=0.7,constant=0.4,constant=0.1"},
};

} // namespace

std::span<const AssignmentPicture> picturesOf(Sheet sheet) {
  return sheet == Sheet::A ? std::span<const AssignmentPicture>(kPicturesA) : kPicturesB;
}

std::span<const AssignmentExperiment> experimentsOf(Sheet sheet) {
  return sheet == Sheet::A ? std::span<const AssignmentExperiment>(kExperimentsA) : kExperimentsB;
}

} // namespace vkpt
