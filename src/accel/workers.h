#pragma once
// Threads that run the iterations of one loop at a time.

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace vkpt::accel {

/// A loop over independent iterations, on the calling thread and `threads - 1` more that live as long as
/// this.
class Workers {
public:
  /// 0: as many as the machine has. Where the system refuses a thread, there are fewer.
  explicit Workers(unsigned threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Calls `body(i)` once for each i < count, in no order, and returns when all are done. The first exception
  /// is rethrown; iterations not begun by then are left out. Not to be called from within a body.
  void forEach(std::size_t count, const std::function<void(std::size_t)>& body);

private:
  void serve();
  void runIterations();

  std::vector<std::thread> m_threads;
  std::mutex m_mutex;
  std::condition_variable m_wake, m_idle;
  const std::function<void(std::size_t)>* m_body = nullptr;
  std::size_t m_count = 0;
  std::atomic<std::size_t> m_next{0};
  std::uint64_t m_loop = 0; ///< number of the loop: a thread joins each once
  std::size_t m_busy = 0;   ///< threads that have not left the loop yet
  bool m_stop = false;
  std::exception_ptr m_error;
};

} // namespace vkpt::accel
