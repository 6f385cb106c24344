import { onBeforeUnmount, shallowRef, type ShallowRef } from 'vue';

import type { DeviceFiles } from '#hex/device-files';

import type { WithLate } from '../../../kit/state/late-models';
import { realBoard } from '../../../session/run/board/real-board';
import { saveBlob } from '../../../session/work/save-file';
import { pageStorage } from '../../../session/work/storage/memory-storage';
import { fingerprint } from './device-python';
import { knownPrograms } from './known-programs';
import { LentPort } from './lent-port';
import { pageTimer, type Port } from './port';
import { PutError, type PutProblem } from './problem';
import { putFiles, type PutProgress, type PutResult, type PutWish } from './put-files';
import { SerialBoard } from './serial-board';
import { chooseSerialPort } from './serial-port';

/** State of the transfer. */
export type SerialState =
  | { readonly kind: 'ready' }
  /** The browser's own list of devices is open. */
  | { readonly kind: 'choosing' }
  | { readonly kind: 'working'; readonly progress: PutProgress }
  /** These files on the device are unknown to this browser. */
  | {
      readonly kind: 'asking';
      readonly names: readonly string[];
      /** Whether they have been saved on this computer. */
      readonly saved: 'no' | 'going' | 'yes';
      answer(yes: boolean): void;
      save(): void;
    }
  | { readonly kind: 'done'; readonly result: Extract<PutResult, { kind: 'done' }> }
  | { readonly kind: 'failed'; readonly problem: PutProblem };

/**
 * The transfer of files onto a device that runs MicroPython, over the serial line of its cable. The device stays connected
 * after it, so that its output can be seen.
 */
export function useSerialTransfer(app: WithLate, needed: () => DeviceFiles) {
  const shown = realBoard(app);
  const known = knownPrograms(pageStorage());
  const state = shallowRef<SerialState>({ kind: 'ready' });
  let stop = new AbortController();
  onBeforeUnmount(() => stop.abort());

  /** Lets the pupil choose a device and puts everything on it. */
  async function put(which: 'boards' | 'any'): Promise<void> {
    if (state.value.kind === 'choosing' || state.value.kind === 'working' || state.value.kind === 'asking') return;
    stop = new AbortController();
    const { signal } = stop;
    state.value = { kind: 'choosing' };
    try {
      const port = await chooseSerialPort(which, async () => shown.value?.disconnect());
      if (port === null) state.value = { kind: 'ready' };
      else if (signal.aborted) await port.close();
      else state.value = endOf(await transfer(port, signal));
    } catch (error) {
      if (error instanceof PutError) {
        state.value = { kind: 'failed', problem: error.problem };
        return;
      }
      state.value = { kind: 'ready' }; // our own mistake: it is reported, and the dialog stays of use
      throw error;
    }
  }

  async function transfer(port: Port, signal: AbortSignal): Promise<PutResult> {
    const { files, modules } = needed();
    const sums = files.map(({ text }) => fingerprint(new TextEncoder().encode(text)));
    const onProgress = (progress: PutProgress): void => void (state.value = { kind: 'working', progress });
    const isKnown = (sum: string): boolean => known.has(sum);
    const wish = { files, modules, isKnown, mayReplace: ask };
    const lent = new LentPort(port, () => performance.now());
    const result = await putFiles(lent, wish, { timer: pageTimer, signal, onProgress, staysOpen: true });
    if (result.kind === 'done') {
      known.add(sums);
      shown.value = new SerialBoard(result.machine, lent, () => (shown.value = null));
    }
    return result;
  }

  const ask = askIn(state);
  return { state, put, stop: (): void => stop.abort() };
}

/** Asks in the dialog, where the files can be saved before the answer. */
function askIn(state: ShallowRef<SerialState>): PutWish['mayReplace'] {
  return (names, read) =>
    new Promise((resolve) => {
      const show = (saved: 'no' | 'going' | 'yes'): void => {
        state.value = { kind: 'asking', names, saved, answer: resolve, save: () => void save() };
      };
      const save = async (): Promise<void> => {
        show('going');
        try {
          for (const name of names) saveBlob(name, new Blob([await read(name)], { type: 'text/x-python' }));
          show('yes');
        } catch (error) {
          if (!(error instanceof PutError)) throw error; // the transfer has ended with it, and reports so
        }
      };
      show('no');
    });
}

/** A transfer that was stopped before it changed anything has not failed. */
function endOf(result: PutResult): SerialState {
  if (result.kind === 'done') return { kind: 'done', result };
  const { problem } = result;
  return problem.kind === 'stopped' && !problem.isTouched ? { kind: 'ready' } : { kind: 'failed', problem };
}
