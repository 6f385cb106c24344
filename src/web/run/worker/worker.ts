/**
 * The module worker that owns one run, or fits one robot (`fit.ts`). It sends and receives what `protocol.ts` lists; all
 * of its logic is in `runner.ts`.
 */
import { Simulation } from '#simulation/simulation';

import { answerFit, type FitRequest } from './fit';
import { sealSandbox } from './sandbox';
import type { ToWorker } from './protocol';
import { Runner } from './runner';

sealSandbox(globalThis);

// A message to oneself comes back at once, but after the messages already waiting: setTimeout would add 4 ms each time.
const channel = new MessageChannel();
let next: (() => void) | null = null;
channel.port1.onmessage = () => {
  const task = next;
  next = null;
  task?.();
};

const runner = new Runner({
  post: (message) => postMessage(message),
  nowMs: () => performance.now(),
  later(task, delayMs) {
    if (delayMs > 0) {
      setTimeout(task, delayMs);
    } else {
      next = task;
      channel.port2.postMessage(null);
    }
  },
  create: (setup, firmware, outlets) => Simulation.create(setup, firmware, outlets),
});

addEventListener('message', ({ data }: MessageEvent<ToWorker | FitRequest>) => {
  if (data.type !== 'fit') runner.receive(data);
  else void answerFit(data).then((answer) => postMessage(answer));
});
