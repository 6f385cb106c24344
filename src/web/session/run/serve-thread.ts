import type { Answer, Every, Start, StartThread } from '#check/lane';
import type { ClassTask } from '#check/task/task';
import { projectOfTask } from '#check/task/write-task';

import { createWorker } from './worker/create-worker';
import type { FromServer, Opening, ServiceName, Services, ToServer } from './worker/serve/protocol';

/** Starts workers that have a service beside the run. They share the compiled VM. */
export const serveThread =
  <Name extends ServiceName>(
    opening: Opening & { readonly service: Name },
    firmware: WebAssembly.Module,
  ): Start<Services[Name]['request'], Services[Name]['result']> =>
  (heard) => {
    const worker = createWorker();
    const send = (message: ToServer): void => worker.postMessage(message);
    const now = { beat: 0, world: 0 };
    worker.onmessage = ({ data }: MessageEvent<FromServer>) => {
      now.beat += 1;
      if (data.type === 'served') heard(data.answer as Answer<Services[Name]['result']>);
      else now.world = data.world;
    };
    // Without a message it is the worker's own code that did not come.
    worker.onerror = ({ message }: Partial<ErrorEvent>) => heard(message ? { broken: message } : { unloaded: true });
    send({ type: 'serve-open', opening, firmware });
    return {
      ask(request) {
        now.world = 0;
        send({ type: 'serve', request });
      },
      pulse: () => ({ ...now }),
      stop: () => worker.terminate(),
    };
  };

/**
 * Starts workers that check hand-ins of a task.
 *
 * @param starts its start program in other languages
 */
export const checkThread = (
  task: ClassTask,
  firmware: WebAssembly.Module,
  starts: readonly string[] = [],
): StartThread => serveThread({ service: 'check', task: projectOfTask(task), starts }, firmware);

/** Calls a function every `ms` of wall time, for lanes. */
export const every: Every = (ms, act) => {
  const timer = setInterval(act, ms);
  return () => clearInterval(timer);
};

/** Maximum number of workers at a time. Chosen: a class of 24 is done in a second or two, and each takes 20 MB. */
const MOST_LANES = 8;

/** Number of workers that serve side by side; with three or more cores one is left for the page. */
export function laneCount(cores: number = navigator.hardwareConcurrency): number {
  const free = cores > 2 ? cores - 1 : cores;
  return Math.max(1, Math.min(free, MOST_LANES));
}
