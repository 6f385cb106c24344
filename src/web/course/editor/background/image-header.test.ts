import { describe, expect, it } from 'vitest';
import { readImageHeader } from './image-header';

const PNG_START = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0, 0, 0, 13, 0x49, 0x48, 0x44, 0x52];
const png = [...PNG_START, 0, 0, 0x03, 0x20, 0, 0, 0x02, 0x58, 8, 6, 0, 0, 0];
/** With a segment of 4 bytes before the frame header, as cameras write it. */
const jpeg = [0xff, 0xd8, 0xff, 0xe1, 0, 6, 1, 2, 3, 4, 0xff, 0xff, 0xc2, 0, 17, 8, 0x04, 0, 0x03, 0, 3, 0, 0, 0, 0];

const read = (bytes: readonly number[]) => readImageHeader(Uint8Array.from(bytes));

describe('the header of a picture', () => {
  it('tells a PNG of 800 × 600', () => {
    expect(read(png)).toEqual({ type: 'png', widthPx: 800, heightPx: 600 });
  });

  it('tells a JPEG of 768 × 1024, behind what a camera writes before', () => {
    expect(read(jpeg)).toEqual({ type: 'jpeg', widthPx: 768, heightPx: 1024 });
  });

  it('says nothing of other files, of broken off ones and of pictures without pixels', () => {
    expect(readImageHeader(new TextEncoder().encode('<svg xmlns="http://www.w3.org/2000/svg">'))).toBeNull();
    for (let length = 0; length < 24; length += 1) expect(read(png.slice(0, length))).toBeNull();
    for (let length = 0; length < 20; length += 1) expect(read(jpeg.slice(0, length))).toBeNull();
    expect(read([...PNG_START, 0, 0, 0, 0, 0, 0, 0, 9])).toBeNull();
  });

  it('comes to an end with segments of length 0', () => {
    expect(read([0xff, 0xd8, ...Array.from({ length: 200 }, () => [0xff, 0xe0, 0, 0]).flat()])).toBeNull();
  });
});
