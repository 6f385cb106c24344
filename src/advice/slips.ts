import type { AdviceKey, AdviceValues } from './text';

/** A slip that shows in one line, and how that line should be written where there is only one way. */
export interface Slip {
  readonly key: AdviceKey;
  readonly values: AdviceValues;
  readonly line?: string;
}

/**
 * A slip recognised by a pattern. It is searched for in the line without strings and comments; `mend` rewrites the
 * whole line.
 */
interface Rule {
  readonly look: RegExp;
  readonly key: AdviceKey;
  readonly values?: (found: RegExpExecArray) => AdviceValues;
  readonly mend?: (line: string, found: RegExpExecArray) => string;
  /** `mend` leaves strings in the line alone. */
  readonly sparesTexts?: true;
}

const KEYWORDS =
  'and|as|assert|break|class|continue|def|del|elif|else|except|finally|for|from|global|if|import|in|is|lambda|not|or|pass|raise|return|try|while|with|yield';
/** The same with a capital letter, or in capitals. */
const CAPITALS = KEYWORDS.split('|').flatMap((it) => [it.charAt(0).toUpperCase() + it.slice(1), it.toUpperCase()]);
const word = (found: RegExpExecArray): AdviceValues => ({ word: found[1] ?? '' });

/** Words of other languages, programming and natural, that pupils write for a Python word. */
const MEANT: Readonly<Record<string, string>> = {
  wenn: 'if', falls: 'if', si: 'if', se: 'if', unless: 'if not', sonst: 'else', sinon: 'else', altrimenti: 'else',
  solange: 'while', tantque: 'while', mentre: 'while', until: 'while not', forever: 'while True', loop: 'while True', do: 'while True',
  switch: 'if', match: 'if', case: 'elif', foreach: 'for',
}; // prettier-ignore

/** Signs that look like those of Python. */
const SIGNS: Readonly<Record<string, string>> = {
  '–': '-', '—': '-', '−': '-', '×': '*', '·': '*', '÷': '/', '≤': '<=', '≥': '>=', '≠': '!=', '，': ',', '；': ';',
  '（': '(', '）': ')', '：': ':', '＝': '=',
}; // prettier-ignore
const SIGN = new RegExp(`[${Object.keys(SIGNS).join('')}]`);
const COMPARED: Readonly<Record<string, string>> = { '=>': '>=', '=<': '<=', '=!': '!=', '<>': '!=' };
const JOINED: Readonly<Record<string, string>> = { '&&': 'and', '||': 'or', '!': 'not' };
/** Commands that form a statement of their own, whatever variables a program has. */
const COMMANDS =
  'sleep|delay|forward|backward|left|right|leftArc|rightArc|stop|setSpeed|setLED\\w*|setServo|motL|motR|input';
const DOTTED = 'display|music|radio|button_[ab]|accelerometer|compass|pin\\d+|speech|random|math|audio|i2c|uart|robot';

const rules: readonly Rule[] = [
  {
    look: SIGN,
    key: 'error.typedSign',
    values: ([sign]) => ({ sign, right: SIGNS[sign] ?? '' }),
    mend: (line) => line.replace(new RegExp(SIGN, 'g'), (sign) => SIGNS[sign] ?? sign),
  },
  {
    look: /[\u00a0\u200b-\u200d\u2060\ufeff]/,
    key: 'error.hiddenSign',
    mend: (line) => line.replace(/\u00a0/g, ' ').replace(/[\u200b\u200c\u200d\u2060\ufeff]/gu, ''),
  },
  { look: /^(?:\/\/|\/\*)/, key: 'error.commentSign', mend: (line) => line.replace(/\/\/|\/\*/, '#') },
  { look: /^(?:if|elif|else|while|for|def)\b.*\{\s*$/, key: 'error.braces' },
  {
    look: /^(?:else\s+if|elseif|elsif|elif\s+if)\b/,
    key: 'error.elseIf',
    sparesTexts: true,
    mend: (line) => line.replace(/else\s+if|elseif|elsif|elif\s+if/, 'elif'),
  },
  {
    look: /^else\s+[^:\s]/,
    key: 'error.elseCondition',
    sparesTexts: true,
    mend: (line) => line.replace('else', 'elif'),
  },
  { look: /^if\b.*:.*\belse\s*:/, key: 'error.elseSameLine' },
  {
    look: /^(?:if|elif|while)\b.*\s(then|do)\s*:?$/,
    key: 'error.wordTooMuch',
    values: word,
    mend: (line) => line.replace(/\s(?:then|do)\s*:?\s*$/, ':'),
  },
  {
    look: new RegExp(`^(${CAPITALS.join('|')})\\b(?!\\s*[=.(])`),
    key: 'error.keywordSmall',
    sparesTexts: true,
    values: ([, written = '']) => ({ name: written, right: written.toLowerCase() }),
    mend: (line, [, written = '']) => line.replace(written, written.toLowerCase()),
  },
  {
    look: /^for\s+\w+\s+in\s+range\s+(\w+)\s*:?$/,
    key: 'error.rangeBrackets',
    mend: (line) => line.replace(/range\s+(\w+)\s*:?/, 'range($1):'),
  },
  { look: /^for\b(?!.*\bin\b)(?!\s*=)(?!\s+\w+\()/, key: 'error.forForm' },
  {
    look: /^(?:if|elif|while|return)\b.*?(=>|=<|=!|<>)/,
    key: 'error.compareSign',
    values: ([, sign = '']) => ({ sign, right: COMPARED[sign] ?? '' }),
    mend: (line) => line.replace(/=>|=<|=!|<>/g, (sign) => COMPARED[sign] ?? sign),
  },
  { look: /\b(and|or)\s*(?:[<>]|==|!=)/, key: 'error.compareAgain', values: word },
  {
    look: /^(?:if|elif|while)\b.*[<>=]\s*(\d+),(\d+)\s*:$/,
    key: 'error.decimalComma',
    values: ([, whole = '', part = '']) => ({ code: `${whole}.${part}` }),
    mend: (line) => line.replace(/(\d+),(\d+)(\s*:)$/, '$1.$2$3'),
  },
  {
    look: /^([\w.]+)\s*(\+\+|--)$/,
    key: 'error.countStep',
    values: ([, name = '', sign = '']) => ({ sign, code: `${name} ${sign.charAt(0)}= 1` }),
    mend: (line) => line.replace(/\s*([+-])[+-]/, ' $1= 1'),
  },
  {
    look: /(&&|\|\|)|(?:\b(?:if|elif|while|return|and|or)|=)\s*(!)(?!=)/,
    key: 'error.wordForSign',
    values: ([, joined, not = '']) => ({ sign: joined ?? not, right: JOINED[joined ?? not] ?? '' }),
    mend: (line) => line.replace(/\s*(&&|\|\|)\s*/g, (_all, sign: string) => ` ${JOINED[sign] ?? sign} `).replace(/!(?!=)\s*/g, 'not '), // prettier-ignore
  },
  {
    look: /^(\w+)\s*:=/,
    key: 'error.assignSign',
    sparesTexts: true,
    mend: (line) => line.replace(':=', '='),
  },
  {
    look: /^(var|let|const|int|float|double|string|str|bool|boolean|char)\s+\w+\s*(?:=(?!=)|$)/i,
    key: 'error.noDeclaration',
    sparesTexts: true,
    values: word,
    mend: (line) => (line.includes('=') ? line.replace(/\w+\s+/, '') : line),
  },
  {
    look: /^(function|func|fun|fn|define|funktion|fonction|funzione|void|sub)\s+\w+\s*\(/i,
    key: 'error.defWord',
    sparesTexts: true,
    values: word,
    mend: (line) => line.replace(/\w+/, 'def'),
  },
  {
    look: /^def\s+([^\W\d]\w*)\s*:/,
    key: 'error.defBrackets',
    values: ([, name = '']) => ({ code: `def ${name}():` }),
    mend: (line) => line.replace(/\s*:/, '():'),
  },
  { look: /^(?:def|class|for)\s+\d/, key: 'error.nameDigit' },
  { look: /^def\s+\w+\s*\(\s*(?:\d|"")/, key: 'error.defValues' },
  {
    look: /^import\s+\*\s*from\s+(\w+)$|^import\s+(\w+)\s+\*$|^from\s+(\w+)(?:\s+import)?$|^(?:include|using|require)\s+(\w+)$/,
    key: 'error.importForm',
    values: (found) => ({ code: starOf(found) }),
    mend: (line, found) => line.replace(/\S.*/, starOf(found)),
  },
  { look: /^from\s+\w+\s+import\s+\w+\.\w+/, key: 'error.importDot' },
  { look: /^(end\s*(?:if|for|while|def)|end)$/i, key: 'error.endWord', values: word },
  {
    look: new RegExp(`^(${Object.keys(MEANT).join('|')})\\b(?=.*:$)(?!\\s*[=.])`, 'i'),
    key: 'error.otherWord',
    values: ([, written = '']) => ({ word: written, right: MEANT[written.toLowerCase()] ?? '' }),
  },
  {
    look: /^print\s+(?:""|[\w(])/,
    key: 'error.printBrackets',
    sparesTexts: true,
    mend: (line) => line.replace(/print\s+(.*\S)\s*$/, 'print($1)'),
  },
  {
    look: new RegExp(`^(${DOTTED})\\s+([a-z_]+)\\(`),
    key: 'error.missingDot',
    sparesTexts: true,
    values: ([, owner = '', name = '']) => ({ code: `${owner}.${name}` }),
    mend: (line) => line.replace(/(\w)\s+/, '$1.'),
  },
  {
    look: new RegExp(`^([A-Za-z_]\\w*(?:\\.\\w+)+|${COMMANDS})\\s+(?:""|-?\\d[\\d.]*|True|False)$`),
    key: 'error.callBrackets',
    sparesTexts: true,
    values: ([, name = '']) => ({ name }),
    mend: (line) => line.replace(/([\w.]+)\s+(.*\S)\s*$/, '$1($2)'),
  },
  { look: /^[\w.]+\{/, key: 'error.roundBrackets' },
  {
    look: new RegExp(`^(?!(?:${KEYWORDS})\\b)([^\\W\\d]\\w+)\\s+(?!(?:${KEYWORDS})\\b)([^\\W\\d]\\w+)\\s*=(?!=)`, 'u'),
    key: 'error.nameSpace',
    values: ([, one = '', two = '']) => ({ name: `${one}_${two}` }),
  },
  { look: /\{[^{}]*(?:""|\w)\s*=(?!=)|\{\s*""\s+[\d"]/, key: 'error.dictColon' },
  { look: /^[^#]*\)\s+(?!(?:and|as|else|for|from|if|in|is|not|or)\b)\w[\w.]*\(/, key: 'error.twoCommands' },
  { look: /[$?€§°]/, key: 'error.strangeSign', values: ([sign]) => ({ sign }) },
  { look: /(?:[^+\-*/=<>%][=+\-*/<>%]|\b(?:and|or|not|in|is))\s*$/, key: 'error.valueMissing' },
];

/** The line that imports everything of the module which the pattern found. */
function starOf(found: RegExpExecArray): string {
  return `from ${found.slice(1).find((name) => name !== undefined) ?? ''} import *`;
}

/** The slip that a line has, if it looks like one of them; `null` for none. */
export function slipIn(code: string, line: string): Slip | null {
  for (const { look, key, values, mend, sparesTexts } of rules) {
    const found = look.exec(code);
    if (found === null) continue;
    const slip = { key, values: values?.(found) ?? {} };
    // A text or a comment in the line may hold what is being replaced: then nothing is rewritten.
    const isSure = line.trim() === code || !(sparesTexts === true ? /#/ : /["'#]/).test(line);
    if (mend === undefined || !isSure) return slip;
    const mended = mend(line, found);
    return mended === line ? slip : { ...slip, line: mended };
  }
  return null;
}

/** True if two values in brackets have nothing between them; `"a" "b"`, `f"a"` and `1 if a else 2` are Python. */
export function lacksComma(code: string): boolean {
  const inside = Array.from(code.matchAll(/[([{]([^()[\]{}]*)(?=[)\]}])/g), ([, text = '']) => text);
  const between = new RegExp(
    `(?:\\b(?!(?:${KEYWORDS})\\b)\\w+\\s+|""\\s*)\\b(?!(?:${KEYWORDS})\\b)\\w+|\\b(?!(?:${KEYWORDS})\\b)\\w+\\s+""`,
  );
  return inside.some((text) => between.test(text));
}
