import type { RunSetup } from '#simulation/run-setup';
import type { Entry } from './file';
import type { Pairing } from './match';
import { matchSetup, type Files } from './match-setup';
import type { StagePlan } from './stages';

/** The run of a match of a stage. */
export function stageSetup(
  { scene, programs }: Pick<Entry, 'scene' | 'programs'>,
  { entrants }: StagePlan,
  { a, b, seed }: Pairing,
): RunSetup | { readonly problem: string } {
  const filesOf = (place: number): Files => programs[entrants[place] ?? -1]?.files ?? {};
  return matchSetup(scene, filesOf(a), b === null ? null : filesOf(b), seed);
}
