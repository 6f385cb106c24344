import { isMovable } from '#simulation/kinds';
import { isZone } from '#scene/kinds/zone';
import type { Scene } from '#scene/scene';
import type { Check, ClassTask } from './task';

/** A name in a check for which the course has nothing. */
export interface Lost {
  /** Its place in the data of the task. */
  readonly path: string;
  readonly id: string;
  /** The ids that would do. */
  readonly known: readonly string[];
}

/** The names in the checks of a task for which its course has nothing. */
export function lostIn({ checks, project: { scene } }: Pick<ClassTask, 'checks' | 'project'>): readonly Lost[] {
  const [zones, blocks] = [zonesOf(scene), blocksOf(scene)];
  return checks.flatMap((check, place) => {
    const path = `checks[${String(place)}]`;
    const lacking = (names: readonly string[], field: string, known: readonly string[]): readonly Lost[] =>
      names.filter((id) => !known.includes(id)).map((id) => ({ path: `${path}.${field}`, id, known }));
    const lostBlocks = check.type === 'belongs' ? lacking([check.object], 'object', blocks) : [];
    return [...lostBlocks, ...lacking(zonesIn(check), check.type === 'reach' ? 'zones' : 'zone', zones)];
  });
}

/** A sentence about a lost name, with those that there are. */
export function lostProblem({ path, id, known }: Lost): string {
  const have = known.length === 0 ? 'It has none' : `It has: ${known.join(', ')}`;
  return `task.${path}: the course has no ${path.endsWith('object') ? 'movable block' : 'zone'} ${JSON.stringify(id)}. ${have}.`;
}

/** Ids of a course's zones: all of them can be named by a check. */
export const zonesOf = ({ objects }: Scene): readonly string[] => objects.filter(isZone).map(({ id }) => id);

/** Ids of a course's movable blocks. */
export const blocksOf = ({ objects }: Scene): readonly string[] => objects.filter(isMovable).map(({ id }) => id);

/** The zones that a check names. */
function zonesIn(check: Check): readonly string[] {
  if (check.type === 'reach') return check.zones;
  return 'zone' in check && check.zone !== null ? [check.zone] : [];
}
