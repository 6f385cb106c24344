/** Signs that nobody sees, or that turn a text around: format signs, fillers, and separators of lines. */
const UNSEEN = /[\p{Cf}\p{Zl}\p{Zp}\u034f\u115f\u1160\u17b4\u17b5\u3164\uffa0]/gu;

/** Signs that steer a terminal or end a text; tabs and line breaks are none of them. */
const STEERING = /[\u0000-\u0008\u000b\u000c\u000e-\u001f\u007f-\u009f]/g;

/** Joins two pictures into one: 👩‍🔧. */
const JOINER = '\u200d';

const named = (sign: string): string => `⟨U+${(sign.codePointAt(0) ?? 0).toString(16).toUpperCase().padStart(4, '0')}⟩`;

/** A text in which nothing is hidden: two that look the same are the same, and none runs the other way by a sign in it. */
export const unseenShown = (text: string): string =>
  text.replace(UNSEEN, (sign, at: number) =>
    sign === JOINER && at > 0 && /^\p{Extended_Pictographic}/u.test(text.slice(at + 1, at + 3)) ? sign : named(sign),
  );

/** The same, and without signs that steer. */
export const plainText = (text: string): string => unseenShown(text).replace(STEERING, named);
