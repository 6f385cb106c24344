import type { Vec } from '#core/geometry';
import { pointRules } from '#rescue-line/rules';
import { NO_VICTIMS, type Victims } from '#rescue-line/score-sheet';
import type { League } from '#scene/league/league';
import { lengthOf } from '#scene/outline';
import type { Paper, Scene } from '#scene/scene';
import { outlineHolds, shapeOutline } from '#scene/shape/shape';
import type { BlockHandle } from '#world/shapes';

/** The victims in an evacuation zone: round blocks, black ones dead. */
export interface VictimWatch {
  /** Those in safety and those that were moved, now. */
  count(): Victims;
}

interface Watched {
  readonly handle: BlockHandle;
  readonly isDead: boolean;
  readonly radiusMm: number;
  /** The disc on which it stood; `null`: none. */
  readonly disc: { readonly at: Vec; readonly radiusMm: number } | null;
}

/** Watches the victims of a course; `null`: it has no zone. @param block finds a movable block of the run by its id */
export function createVictimWatch(
  { rules, zone }: League,
  objects: Scene['objects'],
  block: (id: string) => BlockHandle | undefined,
): VictimWatch | null {
  if (zone === undefined) return null;
  const inZone = ({ at: [x, y] }: { readonly at: readonly [number, number] }): boolean =>
    Math.abs(x - zone.at[0]) <= zone.size[0] / 2 && Math.abs(y - zone.at[1]) <= zone.size[1] / 2;
  const papers = objects.filter((object): object is Paper => object.type === 'paper' && inZone(object));
  const discs = papers.filter(({ round }) => round === true);
  const isEntry = pointRules[rules].victims.kind === 'points';
  const safe = (color: Paper['color']) =>
    papers.filter((paper) => paper.round !== true && paper.color === color).map((paper) => shapeOutline(paper));
  const [forLiving, forDead] = isEntry ? [safe('black'), safe('black')] : [safe('green'), safe('red')];
  const watched = objects.flatMap((object): readonly Watched[] => {
    const handle = object.type === 'block' && object.round === true && inZone(object) ? block(object.id) : undefined;
    if (handle === undefined || object.type !== 'block') return [];
    const disc = discs.find(({ at }) => at[0] === object.at[0] && at[1] === object.at[1]);
    const around = disc && { at: { x: disc.at[0], y: disc.at[1] }, radiusMm: disc.size[0] / 2 };
    return [{ handle, isDead: object.color === 'black', radiusMm: object.size[0] / 2, disc: around ?? null }];
  });
  const of = { living: watched.filter(({ isDead }) => !isDead).length, dead: watched.filter(({ isDead }) => isDead).length };
  return {
    count() {
      const counted = { living: 0, dead: 0, moved: 0 };
      for (const { handle, isDead, radiusMm, disc } of watched) {
        const { xMm: x, yMm: y } = handle.pose();
        const isSafe = !handle.isHeld() && (isDead ? forDead : forLiving).some((outline) => outlineHolds(outline, { x, y }, 0));
        if (isSafe) counted[isDead ? 'dead' : 'living'] += 1;
        else if (disc !== null && lengthOf(x - disc.at.x, y - disc.at.y) >= disc.radiusMm + radiusMm) counted.moved += 1;
      }
      return { ...NO_VICTIMS, ...counted, of };
    },
  };
} // prettier-ignore
