import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { runnerImport, type InlineConfig } from 'vite';
import { words } from '../build/words';
import type * as SimulatedBoard from '../src/web/pupil/real-device/serial/testing/simulated-board';
import type * as ClassKinds from './class-kinds';
import type { ProbeResult, ProbeTask, SweepTask } from './probe/messages';
import type { runBare, sweepBare } from './probe/run-bare';

const firmware = (): WebAssembly.Module =>
  new WebAssembly.Module(readFileSync(new URL('../.cache/vm/vm.wasm', import.meta.url)));
const bare = (): Promise<{ readonly runBare: typeof runBare; readonly sweepBare: typeof sweepBare }> =>
  loaded('./probe/run-bare.ts');

/** The run of a probe in Node, to compare with what it gives in the worker of an engine. */
export const runInNode = async (task: Omit<ProbeTask, 'firmware'>): Promise<ProbeResult> =>
  (await bare()).runBare({ ...task, firmware: firmware() });

/** The table of a sweep in Node, likewise. */
export const sweepInNode = async (task: Omit<SweepTask, 'firmware'>): Promise<string> =>
  (await bare()).sweepBare({ ...task, firmware: firmware() });

/** The class with a hand-in of every kind. */
export const kindsInNode = (): Promise<typeof ClassKinds> => loaded('./class-kinds.ts');

/** A simulated board at the other end of a cable. */
export const boardInNode = async (files: Readonly<Record<string, string>>): Promise<SimulatedBoard.SimulatedBoard> => {
  const path = '../src/web/pupil/real-device/serial/testing/simulated-board.ts';
  const { simulatedBoard } = await loaded<typeof SimulatedBoard>(path);
  return simulatedBoard({ board: 'microbit-v2', files, firmware: firmware() });
};

/** Modules by their paths: to load one takes two seconds of a processor, and many tests want the same. */
const modules = new Map<string, Promise<unknown>>();

/** Playwright's own loader takes no JSON, which the VM's library and all words are. */
function loaded<Module>(path: string): Promise<Module> {
  const file = fileURLToPath(new URL(path, import.meta.url));
  const options: InlineConfig = { configFile: false, logLevel: 'warn', plugins: [words()] };
  const loading = modules.get(path) ?? runnerImport<Module>(file, options).then(({ module }) => module);
  modules.set(path, loading);
  return loading as Promise<Module>;
}
