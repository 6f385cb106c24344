import type { RunSetup } from '#simulation/run-setup';
import firmwareUrl from '../../.cache/vm/vm.wasm?url';
import type { SoundEvent } from '#board/sound/sound-event';
import type { Heard, Stretch } from './ears';
import type { ProbeAnswer, ProbeResult, ProbeTask, SweepTask } from './messages';

declare global {
  interface Window {
    /** Runs a program without the app, in a worker of its own. Called by the browser tests. */
    probe(setup: RunSetup, untilMs: number): Promise<ProbeResult>;
    /** Runs a sweep in the same way. @returns its table as one line of JSON */
    sweep(setup: RunSetup, vary: readonly string[]): Promise<string>;
    /** Plays sound events into a recording and tells what was heard. */
    hear(events: readonly SoundEvent[], forMs: number, stretches: readonly Stretch[]): Promise<Heard>;
  }
}

const firmware = WebAssembly.compileStreaming(fetch(firmwareUrl));

/** Asks a worker of its own. @throws Error with what broke */
async function asked(task: Omit<ProbeTask, 'firmware'> | Omit<SweepTask, 'firmware'>): Promise<ProbeAnswer> {
  const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
  try {
    const answer = new Promise<ProbeAnswer>((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<ProbeAnswer>) => resolve(data);
      worker.onerror = (event) => reject(new Error(event.message));
    });
    worker.postMessage({ firmware: await firmware, ...task });
    const said = await answer;
    if ('problem' in said) throw new Error(said.problem);
    return said;
  } finally {
    worker.terminate();
  }
}

window.probe = async (setup, untilMs) => {
  const said = await asked({ setup, untilMs });
  if ('result' in said) return said.result;
  throw new Error('no result');
};

window.sweep = async (setup, vary) => {
  const said = await asked({ setup, vary });
  if ('table' in said) return said.table;
  throw new Error('no table');
};

window.hear = async (events, forMs, stretches) => {
  const { hear } = await import('./ears');
  return hear(events, forMs, stretches);
};
