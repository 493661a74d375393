//! Threads: who shares a piece of work, what they work with, and how much stack they have.

mod fork;
mod object_pool;
pub mod stack;
mod thread_pool;

pub use fork::ForkAwarePool;
pub use object_pool::ObjectPool;
pub use thread_pool::ThreadPool;
