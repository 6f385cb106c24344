import { commandList, everywhere } from '../commands';
import type { Options, OptionAbout, WordAbout } from '../about';
import { valuesOf, type Lists } from '../lists';
import { firstWords, quoted, secondWords } from './words';

/** The completion for bash 3.2 and newer. */
export const bashCompletion = (lists: Lists): string => [HEAD, readingWords(), offering(lists), FOOT].join('\n');

const HEAD = `# Completion of parcours for bash. Made by: parcours completion bash

# Offers those of the values that go on from what is typed.
_parcours_offer() {
  local one
  for one in "$@"; do [[ $one == "$cur"* ]] && COMPREPLY+=("$one"); done
}

# Offers files (-f) or folders (-d).
_parcours_paths() {
  local one
  compopt -o filenames 2>/dev/null
  while IFS= read -r one; do COMPREPLY+=("$one"); done < <(compgen "$1" -- "$cur")
}
`;

/** Shell code that finds the command, its words so far, and the option whose value is typed. */
const readingWords = (): string => `# Completes the words from the one with this number on: npx has one more.
_parcours_from() {
  local cur=\${COMP_WORDS[COMP_CWORD]} word value= ended= command= place i
  local -a words=()
  for ((i = $1; i < COMP_CWORD; i++)); do
    word=\${COMP_WORDS[i]}
    if [[ -n $value ]]; then
      [[ $word == '=' ]] || value= # --lang=fr comes in three words
    elif [[ -z $ended && $word == -* ]]; then
      case $word in
        --) ended=1 ;;
        ${textNames().join(' | ')}) value=$word ;;
      esac
    else
      words+=("$word")
    fi
  done
  [[ $cur == '=' ]] && cur=
  cur=\${cur#[\\"\\']}
  case "\${words[0]-} \${words[1]-}" in
${commandList.map(({ name }) => commandCase(name)).join('\n')}
  esac`;

/** Shell code that offers what fits there. */
const offering = (lists: Lists): string => `  if [[ -z $command ]]; then
    case "\${#words[@]} \${words[0]-}" in
      0*) _parcours_offer ${list(firstWords())} ;;
${secondWords()
  .map(([first, seconds]) => `      '1 ${first}') _parcours_offer ${list(seconds)} ;;`)
  .join('\n')}
    esac
    [[ $cur == -* ]] && _parcours_offer ${list(typed(everywhere))}
  elif [[ -n $value ]]; then
    case "$command $value" in
${commandList.flatMap(({ name, options }) => valueCases(name, options, lists)).join('\n')}
    esac
  elif [[ -z $ended && $cur == -* ]]; then
    case $command in
${commandList
  .map(({ name, options }) => `      ${quoted(name)}) _parcours_offer ${list(typed({ ...options, ...everywhere }))} ;;`)
  .join('\n')}
    esac
  else
    case "$command $place" in
${commandList.flatMap(({ name, words }) => wordCases(name, words, lists)).join('\n')}
    esac
  fi
}
`;

const FOOT = `_parcours() { _parcours_from 1; }

_parcours_npx() {
  if [[ COMP_CWORD -gt 1 && \${COMP_WORDS[1]} == parcours ]]; then _parcours_from 2; fi
}

complete -F _parcours parcours
complete -p npx &>/dev/null || complete -o default -F _parcours_npx npx
`;

const typed = (options: Options): readonly string[] => Object.keys(options).map((name) => `--${name}`);

/** The options that take a value, of all commands. */
const textNames = (): readonly string[] => [
  ...new Set(
    commandList.flatMap(({ options }) =>
      Object.entries(options).flatMap(([name, { value }]) => (value === undefined ? [] : [`--${name}`])),
    ),
  ),
];

const list = (values: readonly string[]): string => values.map(quoted).join(' ');

function commandCase(name: string): string {
  const [first = '', second] = name.split(' ');
  const pattern = second === undefined ? `'${first} '*` : `'${first} ${second}'`;
  return `    ${pattern}) command=${quoted(name)} place=$((\${#words[@]} - ${second === undefined ? 1 : 2})) ;;`;
}

/** Shell code that offers the values; `null`: nothing is known of them. */
function offerOf({ choices, path }: OptionAbout | WordAbout, lists: Lists): string | null {
  const values = choices === 'commands' ? firstWords() : choices === undefined ? [] : valuesOf(choices, lists);
  const parts = [
    ...(values.length > 0 ? [`_parcours_offer ${list(values)}`] : []),
    ...(path === undefined ? [] : [`_parcours_paths ${path === 'folder' ? '-d' : '-f'}`]),
  ];
  return parts.length === 0 ? null : parts.join('; ');
}

const valueCases = (name: string, options: Options, lists: Lists): readonly string[] =>
  Object.entries(options).flatMap(([option, about]) => {
    const offer = offerOf(about, lists);
    return offer === null ? [] : [`      ${quoted(`${name} --${option}`)}) ${offer} ;;`];
  });

const wordCases = (name: string, words: readonly WordAbout[], lists: Lists): readonly string[] =>
  words.flatMap((about, place) => {
    const offer = offerOf(about, lists);
    const pattern = about.isRepeated === true ? `${quoted(name)}' '*` : quoted(`${name} ${place}`);
    return offer === null ? [] : [`      ${pattern}) ${offer} ;;`];
  });
