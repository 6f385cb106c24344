import { createHash } from 'node:crypto';
import { describe, expect, it } from 'vitest';
import { linesOf } from './testing/play';

describe('Image', () => {
  it('is made from text, size, bytes or a character', () => {
    const program = `
print(repr(Image()), repr(Image(2, 3)), repr(Image('')))
print(repr(Image('90:09')), repr(Image('1 2\\n345\\n')), repr(Image(2, 2, b'\\x01\\x02\\x0a\\x09')))
print(repr(Image('A')))`;
    expect(linesOf(program)).toEqual([
      "Image('00000:00000:00000:00000:00000:') Image('00:00:00:') Image('')",
      "Image('90:09:') Image('102:345:') Image('12:99:')",
      "Image('09900:90090:99990:90090:90090:')",
    ]);
  });

  it('is asked for pixels by numbers of 32 bits', () => {
    const program =
      'i = Image("1:")\nerr(i.get_pixel, 2 ** 32, 0)\nerr(i.set_pixel, 0, 0, 2 ** 32 + 1)\nerr(i.get_pixel, 2 ** 20, 0)';
    expect(linesOf(program)).toEqual([
      'OverflowError: overflow converting long int to machine word',
      'OverflowError: overflow converting long int to machine word',
      'ValueError: index too large',
    ]);
  });

  it('divided by nothing is as bright as can be', () => {
    const program = "i = Image('09:10:')\nprint(repr(i / 0), repr(i / 0.0), repr(i * float('inf')))";
    expect(linesOf(program)).toEqual(["Image('99:99:') Image('99:99:') Image('99:99:')"]);
  });

  it('is not made from a sign of more than one byte', () => {
    expect(linesOf("err(Image, 'ä')\nerr(Image, '9é:')")).toEqual(
      ['ä', 'é'].map(() => 'ValueError: unexpected character in Image definition'),
    );
  });

  it('prints itself over several lines', () => {
    expect(linesOf("print(Image('12:34'))")).toEqual(['Image(', "    '12:'", "    '34:'", ')']);
  });

  it('calculates', () => {
    const program = `
i = Image('12:34')
print(i.width(), i.height(), i.get_pixel(1, 1), repr(i.invert()), repr(i * 2), repr(i / 2), repr(i + i), repr(i - Image('11:11')))
print(repr(i.shift_left(1)), repr(i.shift_right(1)), repr(i.shift_up(1)), repr(i.shift_down(1)), repr(i.crop(1, 0, 3, 2)))
i.set_pixel(0, 0, 9)
i.fill(5)
i.blit(Image('99:99'), 0, 0, 1, 1, 1, 1)
print(repr(i), repr(i.copy()))`;
    expect(linesOf(program)).toEqual([
      "2 2 4 Image('87:65:') Image('24:68:') Image('11:22:') Image('24:68:') Image('01:23:')",
      "Image('20:40:') Image('01:03:') Image('34:00:') Image('00:12:') Image('200:400:')",
      "Image('55:59:') Image('55:59:')",
    ]);
  });

  it('has 64 built-in pictures, 12 clocks and 8 arrows', () => {
    const program = `
print(len([n for n in dir(Image) if n[0].isupper() and isinstance(getattr(Image, n), Image)]))
print(len(Image.ALL_CLOCKS), Image.ALL_CLOCKS[0] is Image.CLOCK12, len(Image.ALL_ARROWS), Image.ALL_ARROWS[1] is Image.ARROW_NE)
print(repr(Image.HEART), repr(Image.SCISSORS), Image.HEART.get_pixel(1, 0), Image.SKULL.width())`;
    expect(linesOf(program)).toEqual([
      '64',
      '12 True 8 True',
      "Image('09090:99999:99999:09990:00900:') Image('99009:99090:00900:99090:99009:') 9 5",
    ]);
  });

  it('does not let a built-in picture change', () => {
    const program = `
err(Image.HEART.set_pixel, 0, 0, 1)
err(Image.HEART.fill, 1)
copy = Image.HEART.copy()
copy.set_pixel(0, 0, 3)
print(copy.get_pixel(0, 0), Image.HEART.get_pixel(0, 0))`;
    expect(linesOf(program)).toEqual([
      'TypeError: image cannot be modified (try copying first)',
      'TypeError: image cannot be modified (try copying first)',
      '3 0',
    ]);
  });

  it('refuses mistakes in the words of the device', () => {
    const program = `
i = Image('12:34')
err(Image, 5)
err(Image, 2, 2, b'1')
err(Image, '1a')
err(i.get_pixel, -1, 0)
err(i.get_pixel, 2, 0)
err(i.set_pixel, 0, 0, 10)
err(i.fill, 10)
err(i.blit, 5, 0, 0, 1, 1)
err(i.blit, i, 0, 0, 1, 1, 1)
err(i.blit, i, 0, 0, -1, 1)
err(lambda: i + Image.HEART)
err(lambda: i * -1)`;
    expect(linesOf(program)).toEqual([
      'TypeError: Image(s) takes a string',
      'ValueError: image data is incorrect size',
      'ValueError: unexpected character in Image definition',
      'ValueError: index cannot be negative',
      'ValueError: index too large',
      'ValueError: brightness out of bounds',
      'ValueError: brightness out of bounds',
      'TypeError: expecting an image',
      'TypeError: must specify both offsets',
      'ValueError: size cannot be negative',
      'ValueError: images must be the same size',
      'ValueError: brightness multiplier must not be negative',
    ]);
  });

  it('has every LED of its 64 pictures as in micropython-microbit-v2 microbit_constimage.c', () => {
    const lines = linesOf(`
for n in sorted(dir(Image)):
    if n[0].isupper() and n[:4] != 'ALL_':
        print(n, repr(getattr(Image, n)))`);
    expect(lines).toHaveLength(64);
    expect(lines.join('').replace(/[^9]/g, '')).toHaveLength(605 + 1); // CLOCK9 has a 9 in its name
    expect(createHash('sha256').update(lines.join('\n')).digest('hex')).toBe(
      '4d146ee1385ce2cb470ef036d55d807c71abee528a4a4751c1af7d86ff897867',
    );
  });

  it('has every LED of its 95 letters as in codal-core BitmapFont.cpp', () => {
    const lines = linesOf(`
for code in range(32, 127):
    i = Image(chr(code))
    print(code, ''.join(str(i.get_pixel(n % 5, n // 5)) for n in range(25)))`);
    expect(createHash('sha256').update(lines.join('\n')).digest('hex')).toBe(
      '1811f2cf753ac8206015917b39df56c8fea156cb9cf2185535daf4746b875721',
    );
  });

  it('shifts a picture into a square as wide as it is, as the device does', () => {
    expect(linesOf("print(repr(Image('123:456').shift_down(1)), repr(Image('12:34:56').shift_up(1)))")).toEqual([
      "Image('000:123:456:') Image('34:56:')",
    ]);
  });
});
