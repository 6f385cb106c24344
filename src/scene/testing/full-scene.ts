import { parseScene, parseSceneValue } from '../parse';
import type { SceneProblem } from '../problem';
import type { Scene } from '../scene';

/** A course file with one object of each of the oldest kinds. */
export const full = {
  format: 'parcours-scene',
  version: 2,
  name: 'Test',
  description: 'All kinds of things',
  size: [1200, 900],
  board: 'microbit-v2',
  robot: { type: 'maqueen-lite', at: [600, 450], heading: 90, scale: 1.5 },
  objects: [
    { id: 'a1', type: 'wall', from: [900, 200], to: [900, 700], thickness: 12 },
    { id: 'a2', type: 'block', at: [300, 300], size: [50, 50], turn: 1 },
    { id: 'a3', type: 'fixed-block', at: [100, 300], size: [50, 80] },
    {
      id: 'a4',
      type: 'stroke',
      points: [
        [100, 100],
        [400, 100],
      ],
      width: 15,
      color: 'gray',
    },
  ],
};

/** `full` with some of its properties changed. */
export const changed = (change: object): unknown => ({ ...full, ...change });
/** `full` with one more object, the fifth. */
export const withObject = (object: object): unknown => changed({ objects: [...full.objects, object] });
/** A target as a file may have it. */
export const zone = { id: 'z', type: 'target', at: [100, 100], size: [200, 200] };
/** A mover as a file may have it. */
export const mover = { id: 'm', type: 'mover', at: [100, 100], to: [300, 100], size: [50, 50] };
/** A label as a file may have it. */
export const label = { id: 'l', type: 'label', at: [100, 100], text: 'Start' };
/** A background as a file may have it. */
export const background = { at: [0, 0], size: [400, 300], cells: [4, 3], levels: 'AAAA' };
/** `full` with a background, changed as given. */
export const withBackground = (change: object): unknown => changed({ background: { ...background, ...change } });
/** A wall as a file may have it. */
export const wall = { id: 'w', type: 'wall', from: [0, 0], to: [100, 0] };

/** The scene that a file gives; throws when it gives none. */
export function sceneOf(value: unknown): Scene {
  const parsed = parseSceneValue(value);
  if (!('scene' in parsed)) throw new Error(parsed.problem);
  return parsed.scene;
}

/** The problem of a file, given as text or as a value. */
export function problemsOf(value: unknown): readonly SceneProblem[] {
  const parsed = typeof value === 'string' ? parseScene(value) : parseSceneValue(value);
  return 'scene' in parsed ? [] : parsed.problems;
}
