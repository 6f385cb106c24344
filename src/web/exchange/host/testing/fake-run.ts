import type { InputAction } from '#simulation/input';
import { defaultScene } from '#scene/scene';

import { HostView, noHost } from '../../../session/visit/host-view';
import { RunModel } from '../../../session/run/run-model';
import { fakeWorker } from '../../../session/run/testing/fake-worker';
import { soloRun } from '#simulation/run-setup';

/** The page's end of a run whose worker runs no program: it answers at once, except to a start (the test does). */
export function fakeRun() {
  const { sent, say, engine } = fakeWorker();
  const host = new HostView(noHost);
  const nothing = (): void => undefined;
  const run = new RunModel({
    ...engine,
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
  return {
    ...{ run, host, say },
    /** The inputs that were sent to the worker so far. */
    inputs: (): readonly InputAction[] => sent.flatMap((message) => (message.type === 'input' ? [message.action] : [])),
  };
}

/** Until everything that was promised has come. */
export async function settled(): Promise<void> {
  for (let times = 0; times < 50; times += 1) await Promise.resolve();
}
