import { describe, expect, it } from 'vitest';
import { keptLines } from './kept-lines';

const program = 'import robot\n\ndef turn():\n    robot.left(90)\n\n# mine\nturn()\n';

describe('lines that stay as they are', () => {
  it('stay where they are when something below them changes, and go down with what comes above them', () => {
    expect(keptLines(program, program.replace('# mine', '# mine\nturn()'), [3, 4])).toEqual([3, 4]);
    expect(keptLines(program, `# Anna\n${program}`, [1, 3, 4])).toEqual([2, 4, 5]);
  });

  it('are found between several changes at once', () => {
    const after = program.replace('import robot\n', 'import robot\nimport time\n');
    expect(keptLines(program, after.replace('# mine', '# yours'), [7])).toEqual([8]);
    expect(keptLines('a\nb\nkept\nc\nd', 'A\nB\nB\nkept\nC\nD', [3])).toEqual([4]);
  });

  it('are not there any more if one is changed, joined to another or taken away', () => {
    expect(keptLines(program, program.replace('left', 'right'), [4])).toBeNull();
    expect(keptLines(program, program.replace('\n\n# mine', '# mine'), [4])).toBeNull();
    expect(keptLines(program, 'turn()\n', [3])).toBeNull();
    expect(keptLines(program, '', [1])).toBeNull();
  });

  it('let nothing come between them', () => {
    const between = program.replace('def turn():\n', 'def turn():\n    robot.stop()\n');
    expect(keptLines(program, between, [3, 4])).toBeNull();
    expect(keptLines(program, between, [3])).toEqual([3]);
  });

  it('are not moved past each other', () => {
    expect(keptLines('a\nx\nb', 'b\nx\na', [1, 3])).toBeNull();
  });

  it('are nothing if the program never had them', () => expect(keptLines('a', 'b', [2, 400])).toEqual([]));
});
