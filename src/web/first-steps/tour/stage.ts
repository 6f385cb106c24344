import type { Settings } from '../../work/settings/settings';

/**
 * How much of the app is in sight: the microcomputer alone (program, board, console), with the robot in its arena, or
 * with the tools for building courses as well.
 */
export const STAGES = ['board', 'robot', 'all'] as const;
export type Stage = (typeof STAGES)[number];

type Sight = Pick<Settings, 'showBoard' | 'showArena' | 'showTools'>;

/**
 * The stage that is in sight. It is no setting of its own: whatever shows the arena or unfolds the tools (a course, a
 * link, a button) is at another stage by that, so that none can hide what something else needs.
 *
 * @param isUnfolded the tools are unfolded where the settings leave it open: everywhere but on a phone
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
