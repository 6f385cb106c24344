import { filesByName, type SourceFile } from '#project/project';
import type { ReferenceContext } from '#reference/context';
import type { Hardware } from '#simulation/hardware';

import { modulesFor } from './modules-for';

/** A file of a project, among all its files, and what it is to run on; `null`: nobody knows. */
export interface Written {
  readonly hardware: Hardware | null;
  readonly files: readonly SourceFile[];
  readonly file: string;
}

/** What the names in a file mean: those of its board, firmware, robot, and of the other files. */
export function contextOf({ hardware, files, file }: Written): ReferenceContext {
  const { board, firmware, robot } = hardware ?? { board: null, firmware: null, robot: null };
  return {
    board: board?.id === 'calliope-mini-3' ? 'calliope-mini-3' : 'microbit-v2',
    features: firmware?.features ?? [],
    modules: modulesFor(robot?.id ?? null),
    files: filesByName(files.filter(({ name }) => name !== file)),
  };
}
