import { isSame } from '#core/same';
import type { CheckResult, WorldResult } from './result';
import { worldName, type ClassTask, type WorldVariant } from './task/task';

/** A hidden world in which the model solution does the same as in another one. */
export interface EqualWorlds {
  /** Its name for people. */
  readonly id: string;
  /** The first world with the same result. */
  readonly other: string;
}

/**
 * The hidden worlds that test nothing new: a program written for another world alone passes there, too. Inputs to the
 * board differ on purpose, and a good solution may answer two buttons alike: such worlds are compared only with one
 * another.
 *
 * @param solution the result of the task's model solution
 */
export function equalWorlds({ worlds }: ClassTask, solution: CheckResult): readonly EqualWorlds[] {
  const outcomeIn = (world: WorldVariant) => solution.worlds.find(({ id }) => id === world.id);
  return worlds.flatMap((world, place) => {
    const ran = outcomeIn(world);
    if (!world.hidden || ran?.passed !== true) return [];
    const other = worlds.slice(0, place).find((before) => {
      const beside = outcomeIn(before);
      const isAsked = isSame(world.sensors, before.sensors) && isSame(world.inputs, before.inputs);
      return isAsked && beside !== undefined && isSame(shownOf(ran), shownOf(beside));
    });
    return other === undefined ? [] : [{ id: worldName(world), other: worldName(other) }];
  });
}

/** All that a run shows, without the world's name. */
const shownOf = ({ hash, passed, atMs, touches, held, missed }: WorldResult) => ({
  hash,
  passed,
  atMs,
  touches,
  held,
  missed,
});
