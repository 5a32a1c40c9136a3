#include "accel/workers.h"

#include <algorithm>
#include <system_error>

namespace vkpt::accel {

Workers::Workers(unsigned threads) {
  const unsigned wanted = threads != 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
  m_threads.reserve(wanted - 1);
  try {
    while (m_threads.size() + 1 < wanted)
      m_threads.emplace_back([this] { serve(); });
  } catch (const std::system_error&) {
    // Those that did start do the work: only the time depends on their number.
  }
}

Workers::~Workers() {
  {
    const std::lock_guard lock(m_mutex);
    m_stop = true;
  }
  m_wake.notify_all();
  for (std::thread& t : m_threads)
    t.join();
}

void Workers::forEach(std::size_t count, const std::function<void(std::size_t)>& body) {
  {
    const std::lock_guard lock(m_mutex);
    m_body = &body;
    m_count = count;
    m_next = 0;
    m_error = nullptr;
    m_busy = m_threads.size();
    ++m_loop;
  }
  m_wake.notify_all();
  runIterations();
  std::unique_lock lock(m_mutex);
  m_idle.wait(lock, [this] { return m_busy == 0; });
  if (m_error)
    std::rethrow_exception(m_error);
}

void Workers::serve() {
  std::uint64_t seen = 0;
  std::unique_lock lock(m_mutex);
  for (;;) {
    m_wake.wait(lock, [&] { return m_stop || m_loop != seen; });
    if (m_stop)
      return;
    seen = m_loop;
    lock.unlock();
    runIterations();
    lock.lock();
    if (--m_busy == 0)
      m_idle.notify_one();
  }
}

void Workers::runIterations() {
  try {
    for (std::size_t i = m_next++; i < m_count; i = m_next++)
      (*m_body)(i);
  } catch (...) {
    const std::lock_guard lock(m_mutex);
    if (!m_error)
      m_error = std::current_exception();
    m_next = m_count;
  }
}

} // namespace vkpt::accel
