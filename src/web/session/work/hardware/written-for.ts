import { microbitV2 } from '#board/boards/microbit-v2';
import { freeReference } from '#libraries/reference';
import { filesByName, type SourceFile } from '#project/project';
import type { ReferenceContext } from '#reference/context';
import type { RobotReference } from '#reference/types';
import { robotReferences } from '#robots/references';
import type { Hardware } from '#simulation/hardware';

/** A file of a project, among all its files, and its target; `null` if that is unknown. */
export interface Written {
  readonly hardware: Hardware | null;
  readonly files: readonly SourceFile[];
  readonly file: string;
}

/** The context of the names in a file: those of its board, firmware, robot, and of the other files. */
export function contextOf({ hardware, files, file }: Written): ReferenceContext {
  const { board, firmware, robot } = hardware ?? { board: null, firmware: null, robot: null };
  return {
    board: (board ?? microbitV2).api,
    features: firmware?.features ?? [],
    modules: modulesFor(robot?.id ?? null),
    files: filesByName(files.filter(({ name }) => name !== file)),
  };
}

/** All libraries, those of the chosen robot first: where two have the same name, its own counts. */
function modulesFor(robot: string | null): RobotReference['modules'] {
  const isChosen = (it: RobotReference): boolean => it.robot === robot;
  const others = robotReferences.filter((it) => !isChosen(it));
  return [...robotReferences.filter(isChosen), ...others, freeReference].flatMap(({ modules }) => modules);
}
