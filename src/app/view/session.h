#pragma once
// The preview: watches the render loop, and between its units of work keeps the window alive.

#include "app/render_run.h"
#include "app/view/camera_rig.h"
#include "app/view/event_log.h"
#include "app/view/panel.h"
#include "app/view/presenter.h"
#include "app/view/saving.h"
#include "core/clock.h"
#include "render/render_loop.h"

namespace vkpt {

struct SessionOptions {
  RenderOptions render;
  bool outputsNamed = false; ///< by --output: saving writes there
  bool logEvents = false;
  bool close = false; ///< the window, when a rule to stop is met
};

class Session : private RenderObserver {
public:
  Session(const SessionOptions& options, PreparedRun& prepared, const gpu::Context& context, Window& window);
  /// Until the user quits. Throws DeviceError; what was rendered is then saved as far as it was read back.
  ExitCode run();

private:
  // Of the render loop.
  void onProgress(const RenderProgress& progress) override;
  void onDispatch() override;
  void onLook(Film&& film, const FilmStatistics& statistics) override;
  bool stopRequested() override;
  bool goesOn(StopReason reason) override;

  void begin(); ///< an empty film, as the settings, the camera and the window ask
  int coarsenessFor(bool moving) const;
  void tick(double wait); ///< hears the user, and shows the film when it is time
  void hear();
  void hearKeys(const Input& input);
  void hearMouse(const Input& input);
  void hearPanel(const PanelRequests& requests);
  void moved(); ///< the camera
  void show();
  bool isDue() const;
  bool mustBegin() const;
  Vec2i pixelAt(Vec2d windowPosition) const;
  void save();
  void rescue(const std::string& error);
  void say(const std::string& message);
  ViewRun viewRun(StopReason stop) const;
  ExitCode conclude();

  const SessionOptions& m_options;
  PreparedRun& m_prepared;
  const gpu::Context& m_context;
  Window& m_window;
  EventLog m_log;
  Stage m_stage;
  Presenter m_presenter;
  CameraRig m_rig;
  Camera m_home;
  Box3d m_box; ///< of the scene, in world coordinates

  ViewSettings m_settings; ///< as the user wants them
  ViewSettings m_begun;    ///< as they were when the film was begun
  RenderJob m_job;         ///< of the loop
  PanelFacts m_facts;      ///< what the panel tells, as of now
  Film m_lastLook;         ///< what is saved when the device is lost
  Vec2i m_windowSize{0};

  bool m_quit = false;
  bool m_moved = false; ///< the film is of another camera or size
  bool m_shown = false; ///< the film was in the window since it was begun
  bool m_stale = true;  ///< the window lacks something
  bool m_firstPicture = false;
  std::uint64_t m_faults = 0; ///< in films that are gone
  double m_showSeconds = 0.0; ///< that the last picture took
  double m_longestWait = 0.0; ///< of the user, in s, once there was a picture
  Stopwatch m_sinceHeard;
  Stopwatch m_sinceMove;
  Stopwatch m_sinceInput;
  Stopwatch m_sinceShown;
  Stopwatch m_sinceFlight;
  Stopwatch m_sinceMessage;
  Stopwatch m_sinceStart;
};

} // namespace vkpt
