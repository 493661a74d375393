//! Threads: the thread pool, pools of reusable objects, `fork`, and stacks for deep recursion.

mod fork;
mod object_pool;
pub mod stack;
mod thread_pool;

pub use fork::ForkAwarePool;
pub use object_pool::ObjectPool;
pub use thread_pool::ThreadPool;
