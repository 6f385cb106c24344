import type { RunSetup } from '#simulation/run-setup';
import firmwareUrl from '../../.cache/vm/vm.wasm?url';
import type { SoundEvent } from '#board/sound/sound-event';
import type { Heard, Stretch } from './ears';
import type { ProbeAnswer, ProbeResult } from './messages';

declare global {
  interface Window {
    /** Runs a program without the app, in a worker of its own. Called by the browser tests. */
    probe(setup: RunSetup, untilMs: number): Promise<ProbeResult>;
    /** Plays sound events into a recording and tells what was heard. */
    hear(events: readonly SoundEvent[], forMs: number, stretches: readonly Stretch[]): Promise<Heard>;
  }
}

const firmware = WebAssembly.compileStreaming(fetch(firmwareUrl));

window.probe = async (setup, untilMs) => {
  const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
  try {
    const answer = new Promise<ProbeAnswer>((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<ProbeAnswer>) => resolve(data);
      worker.onerror = (event) => reject(new Error(event.message));
    });
    worker.postMessage({ firmware: await firmware, setup, untilMs });
    const said = await answer;
    if ('problem' in said) throw new Error(said.problem);
    return said.result;
  } finally {
    worker.terminate();
  }
};

window.hear = async (events, forMs, stretches) => {
  const { hear } = await import('./ears');
  return hear(events, forMs, stretches);
};
