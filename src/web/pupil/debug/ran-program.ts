import { filesOfDevice } from '#project/devices';

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
  const text = run.recording.value.setup?.devices[device]?.files[name];
  const now = filesOfDevice(work.work.value.project, device).find((file) => file.name === name)?.text;
  return text === undefined || text === now ? null : { text, ...movedLines(text, now ?? '') };
}
