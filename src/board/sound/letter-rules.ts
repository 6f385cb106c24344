import { LETTER_RULES } from './letter-rule-table';

/** A rule's context and letters, parsed. */
interface Rule {
  readonly left: string;
  readonly letters: string;
  readonly right: string;
  readonly sounds: string;
}

const VOWELS = 'AEIOUY';
const FRONT_VOWELS = 'EIY';
const VOICED = 'BDVGJLMNRWZ';
/** Endings that do not change the vowel before them. */
const SUFFIXES = ['ER', 'ES', 'ED', 'ELY', 'ING', 'E'];
/** Words that are not stressed. */
const SMALL_WORDS = new Set(
  'A AN AND ARE AS AT BE BUT BY FOR FROM HAS IN IS IT OF ON OR THAT THE TO WAS WITH'.split(' '),
);
const STRESS = '4';

const rulesByLetter: ReadonlyMap<string, readonly Rule[]> = (() => {
  const rules = new Map<string, Rule[]>();
  for (const line of LETTER_RULES.split('\n')) {
    const found = /^(.*?)\[(.+?)\](.*?)=(.*)$/.exec(line);
    if (!found) continue;
    const [, left = '', letters = '', right = '', sounds = ''] = found;
    const first = letters.charAt(0);
    rules.set(first, [...(rules.get(first) ?? []), { left, letters, right, sounds }]);
  }
  return rules;
})();

/**
 * Translates English text to phonemes, by their names in the micro:bit's speech module, words separated by spaces.
 *
 * By letter-to-sound rules in the manner of H. S. Elovitz et al., "Automatic Translation of English Text to Phonetics
 * by Means of Letter-to-Sound Rules", NRL Report 7948 (1976, public domain), with our own table. The device's rules
 * differ, so some words sound different there.
 *
 * @returns `null` for text with a character that the rules do not know
 */
export function phonemesOf(text: string): string | null {
  const padded = ` ${text.toUpperCase()} `;
  let spoken = '';
  let word = '';
  let wordStart = 1;
  for (let place = 1; place < padded.length;) {
    const rule = ruleAt(padded, place);
    if (!rule) return null;
    const isLetter = isLetterAt(padded, place);
    if (isLetter) word += rule.sounds;
    place += rule.letters.length;
    if (!isLetter || !isLetterAt(padded, place)) {
      spoken += isLetter ? stressed(word, padded.slice(wordStart, place)) : rule.sounds;
      word = '';
      wordStart = place;
    }
  }
  return spoken
    .replace(/ +/g, ' ')
    .replace(/ ([.,?-])/g, '$1')
    .trim();
}

function ruleAt(text: string, place: number): Rule | undefined {
  return rulesByLetter
    .get(text.charAt(place))
    ?.find(
      ({ left, letters, right }) =>
        text.startsWith(letters, place) &&
        matchesLeft(text, place - 1, left) &&
        matchesRight(text, place + letters.length, right),
    );
}

const isLetterAt = (text: string, place: number): boolean => /^[A-Z']$/.test(text.charAt(place));
const isVowelAt = (text: string, place: number): boolean => place >= 0 && isOneOf(VOWELS, text.charAt(place));
const isOneOf = (set: string, letter: string): boolean => letter !== '' && set.includes(letter);
const isConsonantAt = (text: string, place: number): boolean =>
  /^[A-Z]$/.test(text.charAt(place)) && !isVowelAt(text, place);

/** Compares a rule's left context with the text, from its end backwards. */
function matchesLeft(text: string, place: number, context: string): boolean {
  const sign = context.at(-1);
  if (sign === undefined) return true;
  const rest = context.slice(0, -1);
  const go = (next: number): boolean => matchesLeft(text, next, rest);
  switch (sign) {
    case ' ':
      return !isLetterAt(text, place) && go(place - 1);
    case '#': {
      if (!isVowelAt(text, place)) return false;
      let next = place;
      while (isVowelAt(text, next)) next--;
      return go(next);
    }
    case ':': {
      let next = place;
      while (isConsonantAt(text, next)) next--;
      return go(next);
    }
    case '^':
      return isConsonantAt(text, place) && go(place - 1);
    case '.':
      return isOneOf(VOICED, text.charAt(place)) && go(place - 1);
    case '+':
      return isOneOf(FRONT_VOWELS, text.charAt(place)) && go(place - 1);
    default:
      return text.charAt(place) === sign && go(place - 1);
  }
}

function matchesRight(text: string, place: number, context: string): boolean {
  if (context === '') return true;
  const rest = context.slice(1);
  const go = (next: number): boolean => matchesRight(text, next, rest);
  switch (context.charAt(0)) {
    case ' ':
      return !isLetterAt(text, place) && go(place + 1);
    case '#': {
      if (!isVowelAt(text, place)) return false;
      let next = place;
      while (isVowelAt(text, next)) next++;
      return go(next);
    }
    case ':': {
      let next = place;
      while (isConsonantAt(text, next)) next++;
      return go(next);
    }
    case '^':
      return isConsonantAt(text, place) && go(place + 1);
    case '.':
      return isOneOf(VOICED, text.charAt(place)) && go(place + 1);
    case '+':
      return isOneOf(FRONT_VOWELS, text.charAt(place)) && go(place + 1);
    case '%':
      return SUFFIXES.some((suffix) => text.startsWith(suffix, place) && go(place + suffix.length));
    default:
      return text.charAt(place) === context.charAt(0) && go(place + 1);
  }
}

/** Marks the first full vowel of a stressed word. */
function stressed(sounds: string, word: string): string {
  if (SMALL_WORDS.has(word) || /\d/.test(sounds)) return sounds;
  return sounds.replace(/IY|IH|EH|AE|AA|AH|AO|OH|UH|UX|ER|EY|AY|OY|AW|OW|UW/, `$&${STRESS}`);
}
