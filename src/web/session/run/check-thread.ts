import type { Every, StartThread } from '#check/lane';
import type { ClassTask } from '#check/task/task';
import { projectOfTask } from '#check/task/write-task';

import { createWorker } from './worker/create-worker';
import type { FromChecker, ToChecker } from './worker/checker';

/**
 * Starts workers that check hand-ins of a task. They share the compiled VM.
 *
 * @param starts its start program in other languages
 */
export const startThread =
  (task: ClassTask, firmware: WebAssembly.Module, starts: readonly string[] = []): StartThread =>
  (heard) => {
    const worker = createWorker();
    const send = (message: ToChecker): void => worker.postMessage(message);
    const now = { beat: 0, world: 0 };
    worker.onmessage = ({ data }: MessageEvent<FromChecker>) => {
      now.beat += 1;
      if (data.type === 'checked') heard(data.answer);
      else now.world = data.world;
    };
    worker.onerror = ({ message }) => heard({ broken: message });
    send({ type: 'check-open', task: projectOfTask(task), firmware, starts });
    return {
      ask(request) {
        now.world = 0;
        send({ type: 'check', request });
      },
      pulse: () => ({ ...now }),
      stop: () => worker.terminate(),
    };
  };

/** Calls a function every `ms` of wall time, for lanes. */
export const every: Every = (ms, act) => {
  const timer = setInterval(act, ms);
  return () => clearInterval(timer);
};

/** Maximum number of workers at a time. Chosen: a class of 24 is done in a second or two, and each takes 20 MB. */
const MOST_LANES = 8;

/** Number of workers that check side by side; with three or more cores one is left for the page. */
export function laneCount(cores: number = navigator.hardwareConcurrency): number {
  const free = cores > 2 ? cores - 1 : cores;
  return Math.max(1, Math.min(free, MOST_LANES));
}
