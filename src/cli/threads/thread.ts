import { fileURLToPath } from 'node:url';
import { setFlagsFromString } from 'node:v8';
import { Worker } from 'node:worker_threads';

/** The scripts of threads, beside the command line's: that of one run, and those that answer requests. */
export type Script = 'worker' | 'check-worker' | 'facts-worker' | 'hint-worker' | 'lab-worker';

/**
 * C stack of a thread in MB. Chosen: deep recursion of a Python program goes through many wasm frames, and the limit
 * that counts must be the VM's own, the same everywhere.
 */
const STACK_MB = 32;

/** JavaScript's memory of a thread that answers requests. Chosen: many times what a run takes; beyond it only the thread ends. */
const HEAP_MB = 512;

/**
 * Room for a thread's young objects from the beginning, in MB: while it grows, it is collected more often, and what lives
 * is copied each time. Measured in a check of six hand-ins: 49 collections become 26. More would take more memory.
 */
const YOUNG_MB = 8;

/**
 * Old objects before they are collected for the first time, in MB. A collection throws away the machine code that knew an
 * object of a run that is over, and the next runs are slow until it is made anew. Chosen: see decision 0112.
 */
const OLD_MB = 32;

/** V8 options for threads that answer requests; worker threads have none of their own for these two. */
const LASTING = [`--min-semi-space-size=${String(YOUNG_MB)}`, `--initial-old-space-size=${String(OLD_MB)}`] as const;

/**
 * V8 options for the threads of a check, whose runs are few and short: V8's helper threads took nearly as long as the runs
 * themselves, on the same cores. Sweeps have no use for them: their code is fast for longer. See decision 0102.
 */
const CHECKING = [
  '--max-inlined-bytecode-size-cumulative=200', // bytes of bytecode; V8's own is 920. Less machine code is made, and sooner
  '--no-parallel-scavenge',
  '--no-concurrent-marking',
] as const;

/** Threads that load their code, and nobody has taken yet. */
const ahead = new Map<Script, Worker>();

/** Starts a thread that a command will want: it loads its code while the command reads what is to do. */
export function loadAhead(script: Script): void {
  const thread = begun(script);
  thread.unref(); // the command may find nothing to do
  ahead.set(script, thread);
}

/** A thread of this script, which awaits its initial data as its first message: the one that has begun to load, or a new one. */
export function threadOf(script: Script): Worker {
  const thread = ahead.get(script);
  ahead.delete(script);
  thread?.ref();
  return thread ?? begun(script);
}

function begun(script: Script): Worker {
  const isLasting = script !== 'worker';
  for (const option of [...(isLasting ? LASTING : []), ...(script === 'check-worker' ? CHECKING : [])])
    setFlagsFromString(option);
  return new Worker(fileURLToPath(new URL(`./${script}.mjs`, import.meta.url)), {
    resourceLimits: { stackSizeMb: STACK_MB, ...(isLasting && { maxOldGenerationSizeMb: HEAP_MB }) },
  });
}
