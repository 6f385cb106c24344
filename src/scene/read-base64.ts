import type { Reader } from './reader';
import { sceneLimits } from './scene';

/** The beginning of a picture's address; base64 follows. */
export const PICTURE = /^data:image\/(?:png|jpeg|webp);base64,/;

/** Reads a text that is base64 after a beginning. Searches for wrong characters in one pass, without backtracking. */
export function readBase64(
  value: unknown,
  path: string,
  beginning: RegExp,
  reader: Reader,
  maxCharacters: number = sceneLimits.pictureCharacters,
): string {
  const text = reader.text(value, path, maxCharacters);
  if (typeof value !== 'string' || (text === '' && value !== '')) return '';
  const start = beginning.exec(text)?.[0].length;
  const content = text.slice(start);
  const isBase64 = content !== '' && content.length % 4 === 0 && !/[^A-Za-z0-9+/=]|=[^=]|===/.test(content);
  if (start !== undefined && isBase64) return text;
  const wanted = beginning === PICTURE ? 'data:image/png, jpeg or webp in base64' : 'base64';
  reader.report('damaged', path, text, `is damaged: it must be ${wanted}.`, { wanted });
  return '';
}
