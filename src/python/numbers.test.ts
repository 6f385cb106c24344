import { describe, expect, it } from 'vitest';
import { numbersIn, numbersOfLine, withNumber } from './numbers';

const textsIn = (text: string): readonly string[] => numbersIn(text).map((one) => one.text);

describe('the numbers of a program', () => {
  it.each([
    [
      'x = [1, 0x1F, 0b1_0, 0o17, 1e-3, 1_000, .5, 1E+5]',
      ['1', '0x1F', '0b1_0', '0o17', '1e-3', '1_000', '.5', '1E+5'],
    ],
    ['x = 5. + 5.5', ['5.', '5.5']],
    ['x = -5. + 5.e3 - 1_0.E-3 * 2', ['-5.', '5.e3', '1_0.E-3', '2']],
    ['x = -5.e+3; y = 5.e; z = 5.e - 3; 6.e-w', ['-5.e+3', '5', '5', '3', '6']],
    ['run2(p1, "3", f"{4:5}", b"6", """7""")  # 8', []],
    ['drive(base-400, base - 3, x2 * -4)', ['400', '3', '-4']],
    ['f(-1, a if b else-2, [1:-3], not -4, - 5)', ['-1', '-2', '1', '-3', '-4', '- 5']],
    ['x -= -3', ['-3']],
    ['x = f(y)-1; z = (y)-2; t[0]-3', ['1', '2', '0', '3']],
    ['return-4', ['-4']],
    ['x = --4', ['-4']],
    ['x = -4**2', ['4', '2']],
  ])('of %s are %j', (text, numbers) => expect(textsIn(text)).toEqual(numbers));

  it('have their values', () => {
    const values = numbersIn('x = [-0x1F, 0b1_0, - 5, -5.e-3, 1_000.5, 3j]').map(({ value }) => value);
    expect(values).toEqual([-31, 2, -5, -0.005, 1000.5, NaN]);
  });

  it('have the line of their digits, also behind a text of several lines', () => {
    const text = 'a = """1\n2"""\r\nb = 3\n\nc = (4 +\n     5)';
    expect(numbersIn(text).map(({ text: number, line }) => [number, line])).toEqual([
      ['3', 3],
      ['4', 5],
      ['5', 6],
    ]);
    expect(numbersOfLine(text, 2)).toEqual([]);
  });

  it('are found around a mistake in another line', () =>
    expect(textsIn('motor(1, 200\nsleep(650)\n')).toContain('650'));
});

describe('another number in its place', () => {
  const written = (text: string, place: number, value: number): string => {
    const at = numbersIn(text)[place];
    return at === undefined ? '' : withNumber(text, at, value);
  };

  it.each([
    ['sleep(650)  # 650', 0, 700, 'sleep(700)  # 650'],
    ['turn(-90)', 0, 45, 'turn(45)'],
    ['turn(90)', 0, -45, 'turn(-45)'],
    ['x = base-400', 0, -5, 'x = base--5'],
    ['return-4', 0, 5, 'return 5'],
    ['return-4', 0, -5, 'return-5'],
    ['x = 4**2', 0, -5, 'x = (-5)**2'],
    ['x = 2**4', 1, -5, 'x = 2**-5'],
    ['x = 5.e3**2', 0, -5, 'x = (-5)**2'],
    ['x = 0x10 if y else 5.', 1, 0.25, 'x = 0x10 if y else 0.25'],
  ])('in %s', (text, place, value, expected) => expect(written(text, place, value)).toBe(expected));
});
