import { commandList, everywhere } from '../commands';
import type { CommandAbout, OptionAbout, WordAbout } from '../about';
import { valuesOf, type Lists } from '../lists';
import { firstWords, quoted, secondWords } from './words';

/** The completion for zsh. */
export const zshCompletion = (lists: Lists): string => `#compdef parcours
# Completion of parcours for zsh. Made by: parcours completion zsh

_parcours_courses() {
  _alternative 'courses:ready course:(${lists.courses.join(' ')})' 'files:file:_files'
}

_parcours() {
  local curcontext=$curcontext state line
  typeset -A opt_args
  if (( CURRENT == 2 )); then
    local -a names=(
${firstWords()
  .map((first) => `      ${quoted(`${first}:${colonsOff(summaryOf(first))}`)}`)
  .join('\n')}
    )
    _describe command names
    _arguments ${optionSpecs(everywhere, lists).join(' ')}
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
${secondWords().map(familyCase).join('\n')}
  esac
  case $command in
${commandList.map((one) => commandCase(one.name, one, lists)).join('\n')}
  esac
}

_parcours_npx() {
  if [[ $words[2] == parcours && CURRENT -gt 2 ]]; then
    shift words
    (( CURRENT-- ))
    _parcours
  else
    _files
  fi
}

compdef _parcours parcours
(( \${+_comps[npx]} )) || compdef _parcours_npx npx
`;

const summaryOf = (first: string): string =>
  commandList.find(({ name }) => name === first || name.startsWith(`${first} `))?.summary ?? '';

const familyCase = ([first, seconds]: readonly [string, readonly string[]]): string => `    ${first})
      if (( CURRENT == 2 )); then
        _values command ${seconds.map(quoted).join(' ')}
        return
      fi
      command="$command $words[2]"
      shift words
      (( CURRENT-- ))
      ;;`;

const commandCase = (name: string, { options, words }: CommandAbout, lists: Lists): string => `    ${quoted(name)})
      _arguments -s -S \\
${[...optionSpecs({ ...options, ...everywhere }, lists), ...words.map((word, place) => wordSpec(word, place, lists))]
  .map((spec) => `        ${spec}`)
  .join(' \\\n')}
      ;;`;

const optionSpecs = (options: Readonly<Record<string, OptionAbout>>, lists: Lists): readonly string[] =>
  Object.entries(options).map(([name, about]) => {
    const { value, help, isRepeated } = about;
    const told = `[${colonsOff(shortened(help)).replace(/[[\]]/g, '\\$&')}]`;
    const taken = value === undefined ? '' : `=${told}:${colonsOff(value)}:${actionOf(about, lists)}`;
    return quoted(`${isRepeated === true ? '*' : ''}--${name}${taken === '' ? told : taken}`);
  });

const wordSpec = (word: WordAbout, place: number, lists: Lists): string =>
  quoted(`${word.isRepeated === true ? '*' : String(place + 1)}:${colonsOff(word.name)}:${actionOf(word, lists)}`);

/** The action that offers the values; a space: there is nothing to offer. */
function actionOf({ choices, path }: OptionAbout | WordAbout, lists: Lists): string {
  if (choices === 'courses') return '_parcours_courses';
  if (choices === 'commands') return `(${firstWords().join(' ')})`;
  if (choices !== undefined) return `(${valuesOf(choices, lists).join(' ')})`;
  return path === undefined ? ' ' : path === 'folder' ? '_files -/' : '_files';
}

const colonsOff = (text: string): string => text.replaceAll('\\', '\\\\').replaceAll(':', '\\:');

/** The help up to where details begin. */
const shortened = (help: string): string => help.replace(/[;:(.](?:\s.*)$/, '').trim();
