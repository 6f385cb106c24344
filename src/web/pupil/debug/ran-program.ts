import { lastMadeOf } from '#core/memo';
import { filesOfDevice } from '#project/devices';
import type { CodeLine } from '#simulation/causes/output';
import type { LineStep } from '#vm/debug/stops';

import type { RunParts } from '../../session/run/parts';
import type { WorkParts } from '../../session/work/model/parts';
import { movedLines, type MovedLines } from './moved-lines';

type Parts = Pick<RunParts, 'run'> & Pick<WorkParts, 'work'>;

/** A file as it runs, and its lines as they are now. */
export interface RanFile extends MovedLines {
  readonly text: string;
}

/**
 * A file of a device as the run has it, where somebody has written in it since; `null`: it is as it ran, or never did.
 */
export function changedFile({ run, work }: Parts, device: number, name: string): RanFile | null {
  const files = run.recording.value.setup?.devices[device]?.files;
  const now = filesOfDevice(work.work.value.project, device).find((file) => file.name === name)?.text ?? null;
  return files?.[name] === undefined || files[name] === now ? null : comparedWith(files, { name, now });
}

/** A file of a run beside its text now: asked for with each picture while somebody drags through time. */
const comparedWith = lastMadeOf(
  (files: Readonly<Record<string, string>>, { name, now }: { readonly name: string; readonly now: string | null }) => {
    const text = files[name] ?? '';
    return { text, ...movedLines(text, now ?? '') };
  },
  (one, other) => one.name === other.name && one.now === other.now,
);

/** The line as the program has it now that a run, or an error of it, names; `null`: it is not there any more. */
export function lineNow(parts: Parts, device: number, { file, line }: CodeLine): number | null {
  const changed = changedFile(parts, device, file);
  return changed === null ? line : changed.now(line);
}

/**
 * The file to show of a program that has been written on since it ran: the wished one if it differs, else the first that
 * does; `null`: none differs.
 */
export function ranFile(parts: Parts, device: number, wished: string): { name: string; text: string } | null {
  const names = Object.keys(parts.run.recording.value.setup?.devices[device]?.files ?? {});
  for (const name of [wished, ...names]) {
    const changed = changedFile(parts, device, name);
    if (changed !== null) return { name, text: changed.text };
  }
  return null;
}

/** Lines that are searched for one that runs. Chosen: nobody writes more while a program stands. */
const MOST_BELOW = 1000;

/**
 * A step as the run knows it: the line up to which it goes, as the program has it now, is that of the program that
 * runs; of a line that was written since, the next one below that runs. `null`: there is none.
 */
export function stepAsRan(parts: Parts, device: number, step: LineStep): LineStep | null {
  const changed = typeof step === 'string' ? null : changedFile(parts, device, step.file);
  if (typeof step === 'string' || changed === null) return step;
  const { file } = step;
  for (let { line } = step; line < step.line + MOST_BELOW; line++) {
    const ran = changed.before(line);
    if (ran !== null) return { file, line: ran };
  }
  return null;
}
