import type { InputAction } from '#simulation/input';
import { defaultScene } from '#scene/scene';

import { HostView, noHost } from '../../../session/visit/host-view';
import type { WorkerPort } from '../../../session/run/run-client';
import { RunModel } from '../../../session/run/run-model';
import type { FromWorker, ToWorker } from '../../../session/run/worker/protocol';
import { soloRun } from '#simulation/run-setup';

/** The page's end of a run whose worker runs no program: it answers at once, except to a start (the test does). */
export function fakeRun() {
  const inputs: InputAction[] = [];
  let current: WorkerPort | null = null;
  const say = (data: FromWorker): void => current?.onmessage?.({ data } as MessageEvent<FromWorker>);
  const createWorker = (): WorkerPort => {
    const worker: WorkerPort = {
      onmessage: null,
      onerror: null,
      postMessage(message: ToWorker) {
        if (message.type === 'run') current = worker;
        if (message.type === 'input') inputs.push(message.action);
        if (message.type === 'stop') queueMicrotask(() => say({ type: 'stopped' }));
      },
      terminate: () => undefined,
    };
    return worker;
  };
  const host = new HostView(noHost);
  const nothing = (): void => undefined;
  const run = new RunModel({
    createWorker,
    firmware: () => Promise.resolve({} as WebAssembly.Module),
    setup: () => soloRun({ scene: defaultScene(), files: {}, robot: 'none', board: 'auto', seed: 1, reality: 0 }),
    onInput: (action) => {
      const { type } = action;
      if (type === 'button' || type === 'touch' || type === 'sensor') host.tell({ type: 'sensed', action });
    },
    onStart: () => host.tell({ type: 'started' }),
    onFailed: (message) => host.tell({ type: 'failed', message }),
    ...{ onOutput: nothing, onEnded: nothing, onRestarted: nothing, onEvents: nothing },
    ...{ onUnavailable: nothing, onRefused: nothing, onKilled: nothing },
  });
  return { run, host, inputs, say };
}

/** Until everything that was promised has come. */
export async function settled(): Promise<void> {
  for (let times = 0; times < 50; times += 1) await Promise.resolve();
}
