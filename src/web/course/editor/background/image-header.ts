/** The facts in the first bytes of a picture. */
export interface ImageHeader {
  readonly type: 'png' | 'jpeg';
  readonly widthPx: number;
  readonly heightPx: number;
}

/**
 * Reads type and size of a PNG or JPEG without decoding it; `null` for anything else, and for files that are cut short.
 */
export function readImageHeader(bytes: Uint8Array): ImageHeader | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  return readPng(view) ?? readJpeg(view);
}

/** The eight bytes with which every PNG begins (ISO/IEC 15948, 5.2). */
const PNG = [0x89504e47, 0x0d0a1a0a] as const;
/** The four letters of its first chunk. */
const IHDR = 0x49484452;

function readPng(view: DataView): ImageHeader | null {
  if (view.byteLength < 24) return null;
  if (view.getUint32(0) !== PNG[0] || view.getUint32(4) !== PNG[1] || view.getUint32(12) !== IHDR) return null;
  return sized('png', view.getUint32(16), view.getUint32(20));
}

/** A JPEG is a row of segments, each a marker and its length; the frame header (ITU-T T.81, B.2.2) holds the size. */
function readJpeg(view: DataView): ImageHeader | null {
  if (view.byteLength < 4 || view.getUint16(0) !== 0xffd8) return null;
  let at = 2;
  while (at + 9 <= view.byteLength) {
    if (view.getUint8(at) !== 0xff) return null;
    const marker = view.getUint8(at + 1);
    if (marker === 0xff) {
      at += 1; // any number of fill bytes may precede a marker
      continue;
    }
    if (isFrame(marker)) return sized('jpeg', view.getUint16(at + 7), view.getUint16(at + 5));
    const isAlone = marker === 0x01 || (marker >= 0xd0 && marker <= 0xd7);
    at += isAlone ? 2 : 2 + Math.max(2, view.getUint16(at + 2));
  }
  return null;
}

/** C0 … CF except the tables DHT (C4), JPG (C8) and DAC (CC). */
const isFrame = (marker: number): boolean =>
  marker >= 0xc0 && marker <= 0xcf && marker !== 0xc4 && marker !== 0xc8 && marker !== 0xcc;

const sized = (type: ImageHeader['type'], widthPx: number, heightPx: number): ImageHeader | null =>
  widthPx > 0 && heightPx > 0 ? { type, widthPx, heightPx } : null;
