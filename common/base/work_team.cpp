// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "base/work_team.h"

#include <chrono>
#include <exception>
#include <new>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace qmesh {

namespace {

constexpr std::chrono::milliseconds kProgressInterval(100);

} // namespace

Status WorkTeam::run(std::size_t threads, const std::function<Status()>& work,
                     const std::function<double()>& done) {
  running_ = threads;
  std::vector<std::thread> team;
  try {
    while (team.size() < threads)
      team.emplace_back([&] { finish(enterAndWork(work)); });
  } catch (const std::system_error&) { // the system makes no more
    const std::lock_guard<std::mutex> lock(mutex_);
    running_ -= threads - team.size();
  }
  if (team.empty() && threads > 0) {
    running_ = 1;
    finish(enterAndWork(work));
  }
  watch(done);
  for (std::thread& member : team)
    member.join();
  if (!status_.ok())
    return status_;
  return interrupted_ ? Status(Code::interrupted, "stopped before the set was complete") : Status();
}

Status WorkTeam::enterAndWork(const std::function<Status()>& work) const {
  return safely([&] {
    enter_();
    return work();
  });
}

/// An exception that left a thread would end the process, which may be somebody else's.
Status WorkTeam::safely(const std::function<Status()>& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return {Code::internal,
            "not enough memory; a smaller --memory or fewer --num-threads need less"};
  } catch (const std::exception& fault) {
    return {Code::internal, std::string("a fault of this program: ") + fault.what()};
  }
}

void WorkTeam::finish(const Status& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!status.ok()) {
    if (status_.ok())
      status_ = status;
    stop_ = true;
  }
  --running_;
  finished_.notify_one();
}

void WorkTeam::watch(const std::function<double()>& done) {
  std::unique_lock<std::mutex> lock(mutex_);
  while (running_ > 0) {
    finished_.wait_for(lock, kProgressInterval);
    lock.unlock();
    if (progress_ && !stop_ && !progress_(done())) {
      interrupted_ = true;
      stop_ = true;
    }
    lock.lock();
  }
}

} // namespace qmesh
