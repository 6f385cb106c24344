import { computed, onBeforeUnmount, shallowRef, type ShallowRef } from 'vue';

import { MAIN, type SourceFile } from '#project/project';
import { saveText } from '../../session/work/save-file';
import { useHardware } from '../../session/work/hardware/use-hardware';
import { usePage } from '../../kit/parts';
import { useWork } from '../../session/work/model/parts';
import { nameToSave } from '../../session/work/work-name';
import { fileName, saveBlob } from '../../session/work/save-file';
import { filesForDevice } from '#hex/device-files';
import { fingerprint } from './device-python';
import { knownPrograms } from './known-programs';
import { pageTimer } from './port';
import { PutError, type PutProblem } from './problem';
import { putFiles, type DeviceFile, type PutProgress, type PutResult, type PutWish } from './put-files';
import { chooseSerialPort, serialAbility } from './serial-port';
import { zipOf } from '../../session/work/zip';

/** State of the transfer. */
export type DeviceState =
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

/** A program that goes to the device instead of the project. */
export interface OtherProgram {
  readonly text: string;
  /** Id of the robot that it drives. */
  readonly robot: string;
  /** Name of the zip file in which all is saved. */
  readonly name: string;
}

/** The transfer of the project, or of another program, to a real device: over the cable, or as files. */
export function useRealDevice(other: OtherProgram | null = null) {
  const app = { ...usePage(), ...useWork() };
  const hardware = useHardware(app);
  const known = knownPrograms(storage());
  const state = shallowRef<DeviceState>({ kind: 'ready' });
  const needed = computed(() =>
    filesOf(other ?? { files: app.work.files.value, robot: hardware.value?.robot?.id ?? null }),
  );
  let stop = new AbortController();
  onBeforeUnmount(() => stop.abort());

  /** Lets the pupil choose a device and puts everything on it. */
  async function put(which: 'boards' | 'any'): Promise<void> {
    if (state.value.kind === 'choosing' || state.value.kind === 'working' || state.value.kind === 'asking') return;
    stop = new AbortController();
    const { signal } = stop;
    state.value = { kind: 'choosing' };
    try {
      const port = await chooseSerialPort(which);
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

  async function transfer(port: Parameters<typeof putFiles>[0], signal: AbortSignal): Promise<PutResult> {
    const { files, modules } = needed.value;
    const sums = files.map(({ text }) => fingerprint(new TextEncoder().encode(text)));
    const onProgress = (progress: PutProgress): void => void (state.value = { kind: 'working', progress });
    const isKnown = (sum: string): boolean => known.has(sum);
    const wish = { files, modules, isKnown, mayReplace: ask };
    const result = await putFiles(port, wish, { timer: pageTimer, signal, onProgress });
    if (result.kind === 'done') known.add(sums);
    return result;
  }

  const ask = askIn(state);
  const base = (): string => other?.name ?? nameToSave(app);
  return {
    state,
    ability: serialAbility(),
    /** The files for the device: libraries, the pupil's files, main.py. */
    files: computed(() => needed.value.files),
    put,
    stop: (): void => stop.abort(),
    saveZip: (): void => {
      const bytes = zipOf(needed.value.files);
      saveBlob(fileName(base(), 'zip'), new Blob([bytes], { type: 'application/zip' }));
    },
    saveOne: ({ name, text }: DeviceFile): void => saveText(app, name, text, 'text/x-python'),
  };
}

/** The files that a board needs for this program and this robot. */
const filesOf = (of: OtherProgram | { readonly files: readonly SourceFile[]; readonly robot: string | null }) =>
  filesForDevice('files' in of ? of.files : [{ name: MAIN, text: of.text }], of.robot);

/** Asks in the dialog, where the files can be saved before the answer. */
function askIn(state: ShallowRef<DeviceState>): PutWish['mayReplace'] {
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
function endOf(result: PutResult): DeviceState {
  if (result.kind === 'done') return { kind: 'done', result };
  const { problem } = result;
  return problem.kind === 'stopped' && !problem.isTouched ? { kind: 'ready' } : { kind: 'failed', problem };
}

/** The browser's storage, or, in a frame that has none, one that forgets. */
function storage(): Pick<Storage, 'getItem' | 'setItem'> {
  try {
    return localStorage;
  } catch {
    return { getItem: () => null, setItem: () => undefined };
  }
}
