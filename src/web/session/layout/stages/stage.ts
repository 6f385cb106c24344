import type { Settings } from '../../work/settings/settings';

/**
 * The stages, by how much of the app is in sight: the microcomputer alone (program, board, console), with the robot in
 * its arena, or with the tools for building courses as well.
 */
export const STAGES = ['board', 'robot', 'all'] as const;
export type Stage = (typeof STAGES)[number];

type Sight = Pick<Settings, 'showBoard' | 'showArena' | 'showTools'>;

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
