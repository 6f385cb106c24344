/** Invisible characters and those that reverse the text's direction: format characters, fillers, line separators. */
const UNSEEN = /[\p{Cf}\p{Zl}\p{Zp}\u034f\u115f\u1160\u17b4\u17b5\u3164\uffa0]/gu;

/** Control characters that steer a terminal or end a text, without tabs and line breaks. */
const STEERING = /[\u0000-\u0008\u000b\u000c\u000e-\u001f\u007f-\u009f]/g;

/** Joins two pictures into one: 👩‍🔧. */
const JOINER = '\u200d';

const named = (sign: string): string => `⟨U+${(sign.codePointAt(0) ?? 0).toString(16).toUpperCase().padStart(4, '0')}⟩`;

/** A text with its invisible characters, and those that reverse its direction, written as codes. */
export const unseenShown = (text: string): string =>
  text.replace(UNSEEN, (sign, at: number) =>
    sign === JOINER && at > 0 && /^\p{Extended_Pictographic}/u.test(text.slice(at + 1, at + 3)) ? sign : named(sign),
  );

/** The same, with its control characters written as codes, too. */
export const plainText = (text: string): string => unseenShown(text).replace(STEERING, named);
