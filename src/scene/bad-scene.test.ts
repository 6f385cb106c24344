import { describe, expect, it } from 'vitest';
import { changed, full, label, mover, problemsOf, wall, withBackground, withObject, zone } from './testing/full-scene';

describe('a bad course file', () => {
  const nested = `${'['.repeat(200_000)}${']'.repeat(200_000)}`;
  const table: readonly [what: string, input: unknown, code: string, path: string, message: RegExp][] = [
    ['empty', '', 'not-json', '', /line 1, column 1, where it ends/],
    ['cut off', '{\n  "format": "parcours-scene",\n', 'not-json', '', /line 3, column 1, where it ends/],
    ['with a comment', '{\n  // my course\n}', 'not-json', '', /line 2, column 3, at "\/\/ my course"/],
    ['a picture', '\u0089PNG\r\n', 'not-json', '', /line 1, column 1/],
    ['9 million characters', ' '.repeat(9_000_000), 'too-long', '', /9000000 characters; the limit is 8000000/],
    ['nested 200,000 deep', nested, 'not-a-scene', 'format', /must be "parcours-scene"/],
    ['a bare number', '42', 'not-a-scene', 'format', /This is not a course file/],
    ['another format', { format: 'x', version: 1 }, 'not-a-scene', 'format', /This is not a course file/],
    [
      'version 7',
      changed({ version: 7 }),
      'newer-version',
      'version',
      /Scene version 7 is newer than this app \(2\)\. Reload/,
    ],
    ['version 0', changed({ version: 0 }), 'unknown-version', 'version', /Scene version 0 is unknown/],
    ['version as text', changed({ version: '1' }), 'unknown-version', 'version', /unknown/],
    [
      'a version that cannot be written',
      changed({ version: { toString: 1 } }),
      'unknown-version',
      'version',
      /toString/,
    ],
    ['a version of 2.5', changed({ version: 2.5 }), 'unknown-version', 'version', /versions 1 to 2/],
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
    [
      'an option named __proto__',
      JSON.stringify(full).replace('"scale":1.5', '"options":{"__proto__":"x"}'),
      'unknown-value',
      'robot.options.__proto__',
      /cannot be an id/,
    ],
    [
      'an option with a long name',
      changed({ robot: { options: { ['x'.repeat(101)]: 'y' } } }),
      'too-long',
      `robot.options.${'x'.repeat(40)}`,
      /101 characters/,
    ],
    ['a time of 0 s', changed({ task: { seconds: 0 } }), 'out-of-range', 'task.seconds', /0 is not within 1 … 3600/],
    [
      'a task with touching as text',
      changed({ task: { noTouch: 'yes' } }),
      'wrong-type',
      'task.noTouch',
      /true or false, not "yes"/,
    ],
    ['a task of nothing', changed({ task: null }), 'wrong-type', 'task', /an object/],
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
    [
      'an id of __proto__',
      withObject({ ...wall, id: '__proto__' }),
      'unknown-value',
      'objects[4].id',
      /cannot be an id/,
    ],
    [
      'a checkpoint without number',
      withObject({ ...zone, type: 'checkpoint' }),
      'missing',
      'objects[4].number',
      /is missing/,
    ],
    [
      'a checkpoint 100',
      withObject({ ...zone, type: 'checkpoint', number: 100 }),
      'out-of-range',
      'objects[4].number',
      /100 is not within 1 … 99/,
    ],
    [
      'a target with a number',
      withObject({ ...zone, number: 1 }),
      'out-of-range',
      'objects[4].number',
      /1 is not within 0 … 0/,
    ],
    ['a target for 51 blocks', withObject({ ...zone, blocks: 51 }), 'out-of-range', 'objects[4].blocks', /51 is not/],
    [
      'a forbidden zone for a block',
      withObject({ ...zone, type: 'forbidden', blocks: 1 }),
      'out-of-range',
      'objects[4].blocks',
      /1 is not/,
    ],
    [
      'a half round zone',
      withObject({ ...zone, round: 0.5 }),
      'wrong-type',
      'objects[4].round',
      /true or false, not 0.5/,
    ],
    [
      'a mover without turning point',
      withObject({ ...mover, to: undefined }),
      'missing',
      'objects[4].to',
      /is missing/,
    ],
    [
      'a mover that stands still',
      withObject({ ...mover, speed: 0 }),
      'out-of-range',
      'objects[4].speed',
      /0 is not within 5 … 500/,
    ],
    [
      'spikes with a speed',
      withObject({ ...zone, type: 'spikes', speed: 5 }),
      'unknown-property',
      'objects[4].speed',
      /Known here: id, type, at, size, turn/,
    ],
    ['an empty label', withObject({ ...label, text: '' }), 'missing', 'objects[4].text', /must not be empty/],
    ['a label of two lines', withObject({ ...label, text: 'a\nb' }), 'not-one-line', 'objects[4].text', /single line/],
    [
      'a label of 101 letters',
      withObject({ ...label, text: 'x'.repeat(101) }),
      'too-long',
      'objects[4].text',
      /101 characters/,
    ],
    ['a background of text', changed({ background: 'floor.png' }), 'wrong-type', 'background', /an object/],
    [
      'a background of 1 cell too many',
      withBackground({ cells: [1001, 1000] }),
      'too-many',
      'background.cells',
      /1001000 cells/,
    ],
    ['a background of no cells', withBackground({ cells: [0, 5] }), 'out-of-range', 'background.cells[0]', /0 is not/],
    ['a background of no levels', withBackground({ levels: '' }), 'damaged', 'background.levels', /must be base64/],
    ['levels that are cut off', withBackground({ levels: 'AAA' }), 'damaged', 'background.levels', /must be base64/],
    [
      'levels with a foreign sign',
      withBackground({ levels: 'AA-A' }),
      'damaged',
      'background.levels',
      /must be base64/,
    ],
    [
      'levels with a sign after their end',
      withBackground({ levels: 'A=AA' }),
      'damaged',
      'background.levels',
      /base64/,
    ],
    [
      'a picture from elsewhere',
      withBackground({ picture: 'https://x.ch/a.png' }),
      'damaged',
      'background.picture',
      /data:image/,
    ],
    [
      'a picture with scripts',
      withBackground({ picture: 'data:image/svg+xml;base64,AAAA' }),
      'damaged',
      'background.picture',
      /data:image/,
    ],
    [
      'a picture with a tail',
      withBackground({ picture: 'data:image/png;base64,AAAA" onload="x' }),
      'damaged',
      'background.picture',
      /base64/,
    ],
  ];

  it.each(table)('%s is refused', (_what, input, code, path, message) => {
    const [first] = problemsOf(input);
    expect(first?.message).toMatch(message);
    expect({ code: first?.code, path: first?.path }).toEqual({ code, path });
  });

  it('names every problem, at most 20 of them', () => {
    expect(problemsOf(changed({ name: 1, size: 2, objects: [{}] })).map((problem) => problem.path)).toEqual([
      'name',
      'size',
      'objects[0].type',
    ]);
    expect(problemsOf(changed({ objects: Array(500).fill({}) }))).toHaveLength(20);
  });

  it('with more points than 60,000 in all its strokes is refused', () => {
    const stroke = (id: string) => ({ id, type: 'stroke', points: Array(20_001).fill([1, 1]) });
    const [first] = problemsOf(changed({ objects: [stroke('a'), stroke('b'), stroke('c')] }));
    expect(first).toMatchObject({ code: 'too-many', path: 'objects[2].points' });
  });
});
