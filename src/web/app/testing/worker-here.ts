import { Simulation } from '#simulation/simulation';

import type { WorkerPort } from '../../session/run/run-client';
import { answerRepeat, type RepeatAnswer, type RepeatRequest } from '../../session/run/worker/look/repeat';
import type { FromWorker, ToWorker } from '../../session/run/worker/protocol';
import { Runner } from '../../session/run/worker/runner';

/** The page's worker, in the thread of the test: it runs programs and repeats runs. A test that is over ends it. */
export function workerHere(): WorkerPort {
  let isEnded = false;
  const worker: WorkerPort = {
    onmessage: null,
    onerror: null,
    postMessage(message: ToWorker | RepeatRequest) {
      if (message.type === 'repeat') void answerRepeat(message, { post, nowMs: () => performance.now() });
      else setTimeout(() => runner.receive(structuredClone(message)));
    },
    terminate: () => void (isEnded = true),
  };
  /** As a browser does, it comes later. */
  function post(data: FromWorker | RepeatAnswer): void {
    setTimeout(() => {
      if (!isEnded) worker.onmessage?.({ data } as MessageEvent<FromWorker>);
    });
  }
  const runner = new Runner({
    post,
    nowMs: () => performance.now(),
    later: (task, delayMs) => void setTimeout(() => !isEnded && task(), delayMs),
    create: (setup, firmware, outlets) => Simulation.create(setup, firmware, outlets),
  });
  return worker;
}
