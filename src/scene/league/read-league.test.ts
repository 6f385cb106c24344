import { describe, expect, it } from 'vitest';
import { applyEdit } from '../edit';
import { inverse } from '../inverse';
import type { League } from './league';
import { parseScene, parseSceneValue } from '../parse';
import { defaultScene, SCENE_FORMAT, SCENE_VERSION, type Scene } from '../scene';
import { serializeScene } from '../serialize';

const league: League = {
  rules: 'line-entry-2026',
  tiles: [
    { at: [150, 150], heading: 0 },
    { at: [450, 150], heading: 90, gaps: 2, crossings: 1, obstacles: 1, checkpoint: true },
    { at: [450, 450], heading: 90, afterZone: true },
  ],
  zone: { at: [600, 900], size: [1200, 900] },
};
const scene: Scene = { ...defaultScene(), league };

describe('the league of a course', () => {
  it('comes out of its file as it went in', () => {
    expect(parseScene(serializeScene(scene))).toEqual({ scene });
  });

  it('is what makes a file one of the newest version: without it the course is written as before', () => {
    expect(serializeScene(scene)).toContain(`"version": ${String(SCENE_VERSION)}`);
    expect(serializeScene(defaultScene())).toContain('"version": 2');
    expect(parseScene(serializeScene(defaultScene()))).toEqual({ scene: defaultScene() });
  });

  it('can be given, changed and taken away, each time with a way back', () => {
    const bare = defaultScene();
    const edit = { type: 'course', changes: { league } } as const;
    const none = { type: 'course', changes: { league: null } } as const;
    expect(applyEdit(bare, edit)).toEqual(scene);
    expect(applyEdit(applyEdit(bare, edit), inverse(bare, edit))).toEqual(bare);
    expect(applyEdit(scene, none)).toEqual(bare);
    expect(applyEdit(applyEdit(scene, none), inverse(scene, none))).toEqual(scene);
    expect(applyEdit(bare, none)).toBe(bare);
  });

  it('is refused with place and way out', () => {
    const problemsOf = (said: unknown): readonly string[] => {
      const parsed = parseSceneValue({ format: SCENE_FORMAT, version: SCENE_VERSION, league: said });
      return 'problems' in parsed ? parsed.problems.map(({ message }) => message) : [];
    };
    const { tiles } = league;
    expect(problemsOf({ tiles })[0]).toBe('league.rules: is missing; it must be one of line-2025, line-entry-2026.');
    expect(problemsOf({ rules: 'line-1999', tiles })[0]).toContain('"line-1999" is unknown. Known: line-2025');
    expect(problemsOf({ rules: 'line-2025', tiles: [] })[0]).toBe('league.tiles: 0 entries; there may be 1 … 1000.');
    const wrong = [tiles[0], { at: [0, 0], heading: 45, gaps: 30 }];
    expect(problemsOf({ rules: 'line-2025', tiles: wrong })).toEqual([
      'league.tiles[1].heading: must be one of 0, 90, 180, 270.',
      'league.tiles[1].gaps: 30 is not within 0 … 20.',
    ]);
    expect(problemsOf({ ...league, zone: { at: [0, 0], size: [1, 1] } })[0]).toContain('league.zone.size[0]: 1 is not');
  });
});
