import type { Settings } from '../../work/settings/settings';

/**
 * The stages, by how much of the app is in sight: the microcomputer alone (program, board, console), with the robot in
 * its arena, or with the tools for building courses as well.
 */
export const STAGES = ['board', 'robot', 'all'] as const;
export type Stage = (typeof STAGES)[number];

type Sight = Pick<Settings, 'showBoard' | 'showArena' | 'showTools'>;

/**
 * The present stage. It is not a setting of its own: showing the arena or unfolding the tools (by a course, a link, a
 * button) changes the stage, so that a stage can never hide what something else needs.
 *
 * @param isUnfolded the tools are unfolded if the settings leave it open: everywhere but on a phone
 */
export function stageOf({ showArena, showTools }: Omit<Sight, 'showBoard'>, isUnfolded: boolean): Stage {
  if (!showArena) return 'board';
  return (showTools ?? isUnfolded) ? 'all' : 'robot';
}

/** The settings that bring a stage into sight. The board belongs to all of them. */
export function sightOf(stage: Stage): Partial<Sight> {
  switch (stage) {
    case 'board':
      return { showBoard: true, showArena: false };
    case 'robot':
      return { showBoard: true, showArena: true, showTools: false };
    case 'all':
      return { showBoard: true, showArena: true, showTools: true };
  }
}
