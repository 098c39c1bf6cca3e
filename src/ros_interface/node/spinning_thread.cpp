#include <ros_interface/node/spinning_thread.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <utility>

#include <ros/callback_queue_interface.h>

namespace cable_variation_ros {

struct SpinningThread::Shared {
  std::mutex mutex;
  std::condition_variable changed;
  bool stopped = false;
};

namespace {

constexpr std::chrono::milliseconds kLook(20);

/// One task, called from the queue as callbacks are.
template <typename Shared>
class Call : public ros::CallbackInterface {
 public:
  Call(std::shared_ptr<Shared> shared, std::function<void()> task)
      : shared_(std::move(shared)), task_(std::move(task)) {}

  CallResult call() override {
    {
      const std::lock_guard<std::mutex> lock(shared_->mutex);
      if (shared_->stopped || left_) return Success;  // whoever waited has gone
    }
    try {
      task_();
    } catch (...) {
      error_ = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    done_ = true;
    shared_->changed.notify_all();
    return Success;
  }

  void wait(const std::function<bool()>& goes_on) {
    std::unique_lock<std::mutex> lock(shared_->mutex);
    const auto ended = [&] { return done_ || shared_->stopped; };
    while (!shared_->changed.wait_for(lock, kLook, ended)) {
      if (!goes_on) continue;
      lock.unlock();
      const bool left = !goes_on();
      lock.lock();
      if (!left || ended()) continue;
      left_ = true;
      throw cable_variation::Cancelled();
    }
    if (!done_) throw NodeEnds();
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::shared_ptr<Shared> shared_;
  const std::function<void()> task_;
  std::exception_ptr error_;
  bool done_ = false;
  bool left_ = false;  // nobody waits
};

}  // namespace

SpinningThread::SpinningThread(ros::CallbackQueueInterface& queue)
    : queue_(queue), shared_(std::make_shared<Shared>()) {}

void SpinningThread::run(std::function<void()> task, const std::function<bool()>& goes_on) {
  if (stopped()) throw NodeEnds();
  const auto call = boost::make_shared<Call<Shared>>(shared_, std::move(task));
  queue_.addCallback(call);
  call->wait(goes_on);
}

void SpinningThread::stop() {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  shared_->stopped = true;
  shared_->changed.notify_all();
}

bool SpinningThread::stopped() const {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  return shared_->stopped;
}

}  // namespace cable_variation_ros
