import { describe, expect, it } from 'vitest';
import { findJsonError } from './json-position';
import { parseScene, parseSceneValue } from './parse';
import type { SceneProblem } from './problem';
import { defaultScene, type Scene } from './scene';
import { serializeScene } from './serialize';

const full = {
  format: 'parcours-scene',
  version: 1,
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

const changed = (change: object): unknown => ({ ...full, ...change });
const withObject = (object: object): unknown => changed({ objects: [...full.objects, object] });
const wall = { id: 'w', type: 'wall', from: [0, 0], to: [100, 0] };

function sceneOf(value: unknown): Scene {
  const parsed = parseSceneValue(value);
  if (!('scene' in parsed)) throw new Error(parsed.problem);
  return parsed.scene;
}

function problemsOf(value: unknown): readonly SceneProblem[] {
  const parsed = typeof value === 'string' ? parseScene(value) : parseSceneValue(value);
  return 'scene' in parsed ? [] : parsed.problems;
}

describe('a course file', () => {
  it('is read with all its properties', () => {
    const scene = sceneOf(full);
    expect(scene.robot).toEqual({ type: 'maqueen-lite', at: [600, 450], heading: 90, scale: 1.5, options: {} });
    expect(scene.objects.map((object) => object.id)).toEqual(['a1', 'a2', 'a3', 'a4']);
  });

  it('may leave out everything that has a default', () => {
    expect(sceneOf({ format: 'parcours-scene', version: 1 })).toEqual(defaultScene());
    const scene = sceneOf({
      format: 'parcours-scene',
      version: 1,
      size: [1000, 800],
      objects: [
        { id: 'w', type: 'wall', from: [0, 0], to: [100, 0] },
        { id: 'b', type: 'block', at: [100, 100], size: [50, 50] },
        { id: 's', type: 'stroke', points: [[10, 10]] },
      ],
    });
    expect(scene.robot.at).toEqual([500, 400]);
    expect(scene.objects).toMatchObject([{ thickness: 10 }, { turn: 0 }, { width: 20, color: 'black' }]);
  });

  it('is the same after writing and reading it again', () => {
    const scene = sceneOf(full);
    const text = serializeScene(scene);
    expect(parseScene(text)).toEqual({ scene });
    expect(serializeScene(sceneOf(JSON.parse(text)))).toBe(text);
  });

  it('is written without its defaults, one object per line', () => {
    expect(serializeScene(defaultScene())).toBe(
      '{\n  "format": "parcours-scene",\n  "version": 1,\n  "size": [1200, 900],\n  "robot": { "at": [600, 450] },\n  "objects": []\n}\n',
    );
    expect(serializeScene(sceneOf(withObject(wall)))).toContain(
      '\n    { "id": "w", "type": "wall", "from": [0, 0], "to": [100, 0] }\n  ]\n',
    );
  });

  it('keeps the options of the robot, in the order of their names', () => {
    const text = serializeScene(sceneOf({ ...full, robot: { options: { model: '2E', S1: 'claw' } } }));
    expect(text).toContain('"options": { "S1": "claw", "model": "2E" }');
    expect(sceneOf(JSON.parse(text)).robot.options).toEqual({ S1: 'claw', model: '2E' });
  });

  it('may begin with a byte order mark', () => {
    expect(parseScene(`\ufeff${JSON.stringify(full)}`)).toHaveProperty('scene');
  });
});

describe('a bad course file', () => {
  const nested = `${'['.repeat(200_000)}${']'.repeat(200_000)}`;
  const table: readonly [what: string, input: unknown, code: string, path: string, message: RegExp][] = [
    ['empty', '', 'not-json', '', /line 1, column 1, where it ends/],
    ['cut off', '{\n  "format": "parcours-scene",\n', 'not-json', '', /line 3, column 1, where it ends/],
    ['with a comment', '{\n  // my course\n}', 'not-json', '', /line 2, column 3, at "\/\/ my course"/],
    ['a picture', '\u0089PNG\r\n', 'not-json', '', /line 1, column 1/],
    ['5 million characters', ' '.repeat(5_000_000), 'too-long', '', /5000000 characters; the limit is 4000000/],
    ['nested 200,000 deep', nested, 'not-a-scene', 'format', /must be "parcours-scene"/],
    ['a bare number', '42', 'not-a-scene', 'format', /This is not a course file/],
    ['another format', { format: 'x', version: 1 }, 'not-a-scene', 'format', /This is not a course file/],
    [
      'version 7',
      changed({ version: 7 }),
      'newer-version',
      'version',
      /Scene version 7 is newer than this app \(1\)\. Reload/,
    ],
    ['version 0', changed({ version: 0 }), 'unknown-version', 'version', /Scene version 0 is unknown/],
    ['version as text', changed({ version: '1' }), 'unknown-version', 'version', /unknown/],
    ['no version', changed({ version: undefined }), 'unknown-version', 'version', /unknown/],
    ['a name of number', changed({ name: 3 }), 'wrong-type', 'name', /name: must be a text in quotes, not 3/],
    ['a long name', changed({ name: 'x'.repeat(201) }), 'too-long', 'name', /201 characters/],
    ['a tiny arena', changed({ size: [100, 900] }), 'out-of-range', 'size[0]', /100 is not within 200 … 10000/],
    ['a huge arena', changed({ size: [1200, 1e12] }), 'out-of-range', 'size[1]', /1000000000000 is not within/],
    ['infinite size', JSON.stringify(full).replace('[1200,900]', '[1e999,900]'), 'out-of-range', 'size[0]', /Infinity/],
    ['a size of NaN', changed({ size: [NaN, 900] }), 'out-of-range', 'size[0]', /NaN is not within/],
    ['a size of one number', changed({ size: [1200] }), 'wrong-type', 'size', /two numbers \[x, y\]/],
    ['half millimetres', changed({ size: [1200.5, 900] }), 'not-whole', 'size[0]', /1200.5 must be a whole number/],
    ['a list as robot', changed({ robot: [] }), 'wrong-type', 'robot', /an object/],
    ['a misspelt property', changed({ robots: {} }), 'unknown-property', 'robots', /Known here: format, version/],
    [
      'a robot outside',
      changed({ robot: { at: [1300, 450] } }),
      'robot-outside',
      'robot.at',
      /\[1300, 450\].*1200 × 900/,
    ],
    ['a robot half outside', changed({ robot: { at: [1190, 450] } }), 'robot-outside', 'robot.at', /not wholly inside/],
    [
      'a robot in a wall',
      changed({ robot: { at: [900, 450] } }),
      'robot-inside',
      'robot.at',
      /inside the wall "a1" \(objects\[0\]\)/,
    ],
    ['a robot in a block', changed({ robot: { at: [300, 300] } }), 'robot-inside', 'robot.at', /inside the block "a2"/],
    [
      'a robot of scale 10',
      changed({ robot: { scale: 10 } }),
      'out-of-range',
      'robot.scale',
      /10 is not within 0.5 … 3/,
    ],
    ['options as a list', changed({ robot: { options: ['claw'] } }), 'wrong-type', 'robot.options', /an object/],
    [
      'an option that is a number',
      changed({ robot: { options: { S1: 1 } } }),
      'wrong-type',
      'robot.options.S1',
      /a text in quotes, not 1/,
    ],
    ['objects as object', changed({ objects: {} }), 'wrong-type', 'objects', /a list/],
    [
      '2001 objects',
      changed({ objects: Array(2001).fill(wall) }),
      'too-many',
      'objects',
      /2001 entries; there may be 0 … 2000/,
    ],
    ['null as object', changed({ objects: [null] }), 'wrong-type', 'objects[0]', /not null/],
    [
      'an unknown object',
      withObject({ id: 'x', type: 'tree' }),
      'unknown-value',
      'objects[4].type',
      /"tree" is unknown\. Known: wall/,
    ],
    ['an object without type', withObject({ id: 'x' }), 'missing', 'objects[4].type', /is missing/],
    ['an object without id', withObject({ ...wall, id: undefined }), 'missing', 'objects[4].id', /is missing/],
    [
      'an id twice',
      withObject({ ...wall, id: 'a2' }),
      'duplicate-id',
      'objects[4].id',
      /"a2" is already the id of objects\[1\]/,
    ],
    [
      'a wall of length 0',
      withObject({ ...wall, to: [0, 0] }),
      'wall-without-length',
      'objects[4].to',
      /length 0.*\[0, 0\]/,
    ],
    ['a wall without end', withObject({ ...wall, to: undefined }), 'missing', 'objects[4].to', /is missing/],
    ['a wall far away', withObject({ ...wall, to: [1e9, 0] }), 'out-of-range', 'objects[4].to[0]', /1000000000 is not/],
    [
      'a wall of no thickness',
      withObject({ ...wall, thickness: 0 }),
      'out-of-range',
      'objects[4].thickness',
      /0 is not/,
    ],
    [
      'a block of no size',
      withObject({ id: 'b', type: 'block', at: [1, 1], size: [0, 5] }),
      'out-of-range',
      'objects[4].size[0]',
      /0 is/,
    ],
    [
      'a block turned by 9',
      withObject({ ...full.objects[1], id: 'b', turn: 9 }),
      'out-of-range',
      'objects[4].turn',
      /9 is not within 0 … 7/,
    ],
    [
      'a stroke of nothing',
      withObject({ id: 's', type: 'stroke', points: [] }),
      'out-of-range',
      'objects[4].points',
      /0 entries/,
    ],
    [
      'a bad point',
      withObject({ id: 's', type: 'stroke', points: [[1, 2], [3]] }),
      'wrong-type',
      'objects[4].points[1]',
      /\[3\]/,
    ],
    [
      'a pink stroke',
      withObject({ id: 's', type: 'stroke', points: [[1, 2]], color: 'pink' }),
      'unknown-value',
      'objects[4].color',
      /pink/,
    ],
  ];

  it.each(table)('%s is refused', (_what, input, code, path, message) => {
    const [first] = problemsOf(input);
    expect(first?.message).toMatch(message);
    expect({ code: first?.code, path: first?.path }).toEqual({ code, path });
  });

  it('names every problem, at most 20 of them', () => {
    expect(problemsOf(changed({ name: 1, size: 2, objects: [{}] })).map((problem) => problem.path)).toEqual([
      'size',
      'name',
      'objects[0].type',
    ]);
    expect(problemsOf(changed({ objects: Array(500).fill({}) }))).toHaveLength(20);
  });

  it('with more points than 60,000 in all its strokes is refused', () => {
    const stroke = (id: string) => ({ id, type: 'stroke', points: Array(20_001).fill([1, 1]) });
    const [first] = problemsOf(changed({ objects: [stroke('a'), stroke('b'), stroke('c')] }));
    expect(first).toMatchObject({ code: 'too-many', path: 'objects[2].points' });
  });

  it('may place a robot flush with a wall', () => {
    expect(problemsOf(changed({ robot: { at: [853, 450] } }))).toEqual([]);
  });
});

describe('the place of a mistake in JSON', () => {
  const table: readonly [text: string, line: number, column: number][] = [
    ['[1,]', 1, 4],
    ['{"a" 1}', 1, 6],
    ['{"a":1,}', 1, 8],
    ['{"a":01}', 1, 6],
    ['["\u0007"]', 1, 2],
    ['[1]\n\n]', 3, 1],
    ['{"a":\n  tru}', 2, 3],
    ["['a']", 1, 2],
  ];
  it.each(table)('in %j is found', (text, line, column) => {
    expect(() => void JSON.parse(text)).toThrow();
    expect(findJsonError(text)).toEqual({ line, column });
  });

  it('is nowhere in what JSON.parse accepts', () => {
    for (const text of ['{}', ' [1.5e-3, "a\\u00e9", true, {"a": {"b": []}}] ', '-0', 'null']) {
      expect(() => void JSON.parse(text)).not.toThrow();
      expect(findJsonError(text)).toBeNull();
    }
  });
});
