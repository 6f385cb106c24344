import type { SceneObject, Zone } from '#scene/scene';
import type { Verdict } from '#simulation/task/verdict';

/** How far a zone has been dealt with in this run. */
export type ZoneState = 'open' | 'reached';

/** A checkpoint is reached when it is among the first that were passed; a target, when all of its kind are. */
export function zoneState(zone: Zone, objects: readonly SceneObject[], verdict: Verdict | null): ZoneState {
  if (verdict === null) return 'open';
  const isReached =
    zone.type === 'checkpoint'
      ? objects.filter((other) => other.type === 'checkpoint' && other.number < zone.number).length <
        verdict.checkpoints.passed
      : zone.type === 'target' &&
        isAll(zone.blocks > 0 ? verdict.blocks.delivered : verdict.targets.reached, zone, verdict);
  return isReached ? 'reached' : 'open';
}

const isAll = (count: number, { blocks }: Zone, verdict: Verdict): boolean =>
  count >= (blocks > 0 ? verdict.blocks.of : verdict.targets.of);
