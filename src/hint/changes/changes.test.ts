import { describe, expect, it } from 'vitest';
import { linesToSee, withChange, type Change } from './change';
import { extraChanges, indentChanges, isRight, orderChanges } from './lines';
import { elseChanges, missingChanges, numbersInLine, unusedChanges, waitChanges } from './missing';
import { nameChanges, oppositesOf } from './names';
import { between, coarseValues, numbersOf } from './numbers';
import { readProgram, type Program } from './program';
import { mattersTo } from './reach';
import { comparisonChanges, digitsIn, logicChanges, polarityChanges } from './signs';

/** The changed lines, each change as one text. */
const made = (make: (program: Program) => readonly Change[], text: string): readonly string[] =>
  make(readProgram(text)).map(({ after }) => after.join('\n'));

describe('a change', () => {
  const text = 'a()\nb()\n';

  it('stands before its line if it is an insertion, also at the end of the program', () => {
    const insertion = { kind: 'missing', before: [], after: ['c()'], direction: null } as const;
    expect(withChange(text, { ...insertion, line: 2 })).toBe('a()\nc()\nb()\n');
    expect(withChange(text, { ...insertion, line: 3 })).toBe('a()\nb()\nc()\n');
    expect(linesToSee({ ...insertion, line: 2 }, text)).toEqual([1, 2]);
    expect(linesToSee({ ...insertion, line: 3 }, text)).toEqual([2]);
  });

  it('takes lines away and puts others there', () => {
    const change = { kind: 'order', line: 1, before: ['a()', 'b()'], after: ['b()', 'a()'], direction: null } as const;
    expect(withChange('a()\r\nb()\r\n', change)).toBe('b()\na()\n');
  });
});

describe('the numbers of a program', () => {
  const values = (text: string): readonly number[] => numbersOf(readProgram(text)).map(({ value }) => value);

  it('are those of the syntax tree, not those in texts, comments and names', () => {
    expect(values('x1 = "5" + f"{6}" # 7\ndelay(0x10, 1_000, 1e3, 0.5)\n')).toEqual([16, 1000, 1000, 0.5]);
  });

  it('have a minus only where an operand begins', () => {
    expect(values('motL.rotate(-60)\nmotR.rotate(base-400)\n')).toEqual([-60, 400]);
  });

  it('become greater or less, whole ones whole ones', () => {
    const [place] = numbersOf(readProgram('delay(650)  # turn\n'));
    expect(place?.to(910)).toMatchObject({ after: ['delay(910)  # turn'], direction: 'more', line: 1 });
    expect(place?.to(650)).toBeNull();
    expect(coarseValues(place!).slice(0, 4)).toEqual([1300, 325, 910, 455]);
  });

  it('that count something go up and down by one first', () => {
    const [, place] = numbersOf(readProgram('x = 100\nfor i in range(3):\n    pass\n'));
    expect(coarseValues(place!).slice(0, 2)).toEqual([4, 2]);
  });

  it('are halved where the run got farthest', () => {
    const [place] = numbersOf(readProgram('delay(100)\n'));
    const tried = [100, 140, 200].map((value) => ({ value, score: value === 140 ? 5 : 1 }));
    expect(between(place!, tried).map(({ value }) => value)).toEqual([170, 120]);
  });
});

describe('names', () => {
  it.each([
    ['left', ['right']],
    ['irLeft', ['irRight']],
    ['motL', ['motR']],
    ['irL2', ['irR2']],
    ['turn_left', ['turn_right']],
    ['CLOSED', ['OPEN']],
    ['l', []],
    ['delay', []],
  ])('%s has the opposites %j', (name, opposites) => expect(oppositesOf(name)).toEqual(opposites));

  it('are exchanged for opposites, for slips of the pen and for other constants where they are used', () => {
    const changes = made(nameChanges, 'NEAR = 3\nWIDE = 4\nfoward()\nleft()\ndelay(NEAR)\n');
    expect(changes).toContain('forward()');
    expect(changes).toContain('right()');
    expect(changes).toContain('delay(WIDE)');
  });
});

describe('signs', () => {
  it('of comparisons have their opposite first', () =>
    expect(made(comparisonChanges, 'if a < 3:\n    b()\n')).toEqual(['if a > 3:', 'if a >= 3:', 'if a <= 3:']));

  it('0 and 1 that something is compared with are exchanged, one after the other, then together', () => {
    expect(made(polarityChanges, 'if l() == 0 and r() == 0:\n    delay(1)\n')).toEqual([
      ...['if l() == 1 and r() == 0:', 'if l() == 0 and r() == 1:', 'if l() == 1 and r() == 1:'],
    ]);
  });

  it('0 and 1 that a digital reading is compared with are no numbers to be made greater', () => {
    const program = readProgram('if irLeft.read_digital() == 0 and rounds == 1:\n    delay(1)\n');
    const isDigit = numbersOf(program).map(({ from }) => digitsIn(program).has(from));
    expect(isDigit).toEqual([true, false, false]);
  });

  it('and, or, not and True are exchanged', () => {
    const changes = made(logicChanges, 'while not a:\n    if b and c:\n        d = True\n');
    for (const one of ['while a:', '    if b or c:', '    if not b and c:', '        d = False'])
      expect(changes).toContain(one);
  });
});

describe('lines', () => {
  const text = 'from x import *\nif a:\n    left()\n    delay(3)\nstop()\n';

  it('are taken away one by one, but no imports; alone in its block a line gives way to pass', () => {
    expect(made(extraChanges, 'from x import *\nif a:\n    left()\nstop()\n')).toEqual(['    pass', '']);
  });

  it('are exchanged with neighbours of their block', () => expect(made(orderChanges, text)).toEqual(['    delay(3)\n    left()'])); // prettier-ignore

  it('are moved in and out where that leaves a program', () =>
    expect(made((one) => indentChanges(one).filter((change) => isRight(one, change)), text)).toEqual([
      'delay(3)',
      '    stop()',
    ]));

  it('are moved into the block that they were left out of', () =>
    expect(made(indentChanges, 'if a:\nleft()\n')).toContain('    left()'));

  it('come once more with all names opposite', () =>
    expect(made(missingChanges, 'left_dark = irLeft.read_digital()\n')).toContain(
      'right_dark = irRight.read_digital()',
    ));

  it('come once more, the likely ones first: a wait after a command that drives', () => {
    const changes = made(missingChanges, 'forward()\ndelay(500)\nstop()\nleft()\nstop()\n');
    expect(changes[0]).toBe('delay(500)');
    expect(changes).toContain('setSpeed(50)');
  });

  it('are likeliest where something is defined and never used, a parameter in its function alone', () => {
    const text = 'TURN = 370\ndef turn(way):\n    delay(500)\n    stop()\nturn(left)\n';
    const changes = unusedChanges(readProgram(text), []);
    const codes = changes.map(({ after: [code = ''] }) => code.trim());
    expect(new Set(codes)).toEqual(new Set(['delay(TURN)', 'way()', 'delay(way)']));
    const ways = changes.filter((_, place) => codes[place] === 'way()');
    expect(ways.map(({ line }) => line).sort()).toEqual([3, 4, 5]);
  });

  it('may be the opposite of the line before it, before others', () => {
    const changes = made(missingChanges, 'for i in range(2):\n    half(rightArc)\nfillRGB(0, 80, 0)\n');
    expect(changes.indexOf('    half(leftArc)')).toBeLessThan(changes.indexOf('    fillRGB(0, 80, 0)'));
  });

  it('are waits above all where the robot is told to drive and at once to stop', () => {
    const text = 'TURN = 370\nforward()\nstop()\ndelay(20)\nleft()\ndelay(50)\nstop()\n';
    expect(made(waitChanges, text).slice(0, 3)).toEqual(['delay(TURN)', 'delay(20)', 'delay(50)']);
    expect(new Set(waitChanges(readProgram(text)).map(({ line }) => line))).toEqual(new Set([3]));
  });

  it('are no constants once more, which have their values already', () =>
    expect(made(missingChanges, 'NEAR = 3\nfar = 4\nforward()\n')).not.toContain('NEAR = 3'));

  it('may have other numbers than elsewhere', () => {
    const line = { kind: 'missing', line: 3, before: [], after: ['    drive(1500, 2)'], direction: null } as const;
    const [first, second] = numbersInLine(line);
    expect(first?.to(3000)).toEqual({ ...line, after: ['    drive(3000, 2)'] });
    expect(second?.to(1)).toEqual({ ...line, after: ['    drive(1500, 1)'] });
    expect(first?.to(1500)).toBeNull();
  });

  it('may be an else with one statement', () => {
    const changes = made(elseChanges, 'if a:\n    left()\nelif b:\n    right()\n');
    expect(changes).toContain('else:\n    left()');
    expect(elseChanges(readProgram('if a:\n    left()\n'))[0]).toMatchObject({ line: 3, before: [] });
  });
});

describe('a change that cannot matter', () => {
  const text = 'import x\nif a > 1:\n    b(5)\n    c()\nelif d:\n    e()\nwhile True:\n    f()\ng()\n';
  const program = readProgram(text);
  const matters = mattersTo(program, new Set([1, 2, 5, 8]));
  const lines = (make: (program: Program) => readonly Change[]): readonly number[] =>
    [
      ...new Set(
        make(program)
          .filter(matters)
          .map(({ line }) => line),
      ),
    ].sort((one, other) => one - other);

  it('is one of a number, a name or a whole line that was never come to', () => {
    expect(lines((one) => numbersOf(one).flatMap((place) => place.to(7) ?? []))).toEqual([2]);
    expect(lines(extraChanges)).toEqual([8]);
  });

  it('is a line more beside one that was never come to', () => expect(lines(missingChanges)).toEqual([2, 7, 8, 9]));

  it('is not a line never come to that moves out of its block, or under a line that was', () =>
    expect(lines(indentChanges)).toEqual([2, 3, 4, 5, 6, 7, 8, 9]));
});
