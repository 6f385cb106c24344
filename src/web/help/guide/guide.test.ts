import { describe, expect, it } from 'vitest';

import { LANGUAGES } from '#core/languages';
import { allTools } from '../../course/editor/palette/tool-list';
import { MENU, stepsFor } from '../tour/tour-steps';
import type { GuideContent } from './content/content';
import de from '../words/guide/de.json';
import en from '../words/guide/en.json';
import fr from '../words/guide/fr.json';
import italian from '../words/guide/it.json';
import { allHelpEntries } from './all-help-entries';
import type { HelpEntry } from '../../kit/features/feature';
import { guideSections } from './entries';

const contents: Readonly<Record<(typeof LANGUAGES)[number], GuideContent>> = { de, fr, it: italian, en };
const entries = guideSections(allHelpEntries).flatMap((section) => section.entries);

/** The bars, panes and menus whose controls the help explains. */
const sources = import.meta.glob<string>(
  [
    '../../{app,session,pupil}/**/{TopBar,RunControls,SpeedMenu,DeviceMenu,CourseMenu,MainMenu}.vue',
    '../../pupil/**/{CodePane,FileTabs,BoardPane,BoardPanels,ConsolePane,ConsoleInput}.vue',
    '../../{session,pupil}/**/{ArenaPane,ArenaHead,ArenaFoot,ModeControl,RobotSight,ViewMenu,GhostItems,SwitchButtons}.vue',
    '../../{exchange,help}/**/{ShareButton,LogoButton}.vue',
    '../../course/editor/{EditorActions,EditorMenu,ToolBench}.vue',
    '../../pupil/debug/*.vue',
    '../../pupil/look-back/{PastActions,PastFoot}.vue',
    '../../pupil/next-step/StepReferee.vue',
    '../../course/editor/palette/ToolPalette.vue',
    '../../**/contribution.ts',
    '../../{teacher,help}/*/desk-cards.ts',
  ],
  { query: '?raw', import: 'default', eager: true },
);

/** The controls in a component's template, and the entries of menus and tabs in its script, each by all its names. */
function controlsIn(source: string): readonly (readonly string[])[] {
  const template = source.slice(source.indexOf('<template>'));
  const tags = template.matchAll(
    /<(?:CtlButton|PageButton|MenuButton|button|PageListItem)\b((?:\s+[^\s=>/]+(?:="[^"]*")?)*)\s*(\/?)>/g,
  );
  const inTemplate = Array.from(tags, ({ 1: attributes = '', 2: isEmpty, 0: tag, index }) => {
    const ids = Array.from(attributes.matchAll(/ data-testid="([^"]+)"/g), ({ 1: id = '' }) => id);
    const patterns = Array.from(attributes.matchAll(/:data-testid="`([^`]+)`"/g), ({ 1: id = '' }) =>
      id.replace(/\$\{[^}]*\}/g, '*'),
    );
    const labels = attributes.matchAll(/:(?:label|text|title|aria-label)="([^"]*)"/g);
    const inner = isEmpty === '/' ? '' : (template.slice(index + tag.length).split('</')[0] ?? '');
    const said = [...Array.from(labels, ({ 1: label = '' }) => label), inner].join(' ');
    const keys = Array.from(said.matchAll(/'([a-zA-Z]+\.[a-zA-Z]+)'/g), ({ 1: key = '' }) => key);
    const texts = Array.from(said.matchAll(/\bt\((\w+\.\w+)\)/g), ({ 1: text = '' }) => text);
    return [...ids, ...patterns, ...keys, ...texts];
  });
  return [...inTemplate, ...entriesIn(source)];
}

/** The entries of menus and the tabs in a component's script, each by all names that it has. */
function entriesIn(source: string): readonly (readonly string[])[] {
  const entries = source.matchAll(
    /\bid(?:: [\w'-]+)?, (?:testId: (?:'([^']+)'|`([^`]+)`)|icon: \w+, title: t\('?(\w+\.\w+)'?\))/g,
  );
  return Array.from(entries, ([, id, pattern, text]) => {
    const name = id ?? pattern?.replace(/\$\{[^}]*\}/g, '*') ?? text;
    return name === undefined ? [] : [name];
  });
}

describe('the help', () => {
  it('explains every control of the bars, panes and menus', () => {
    const covered = new Set(entries.flatMap(({ covers }) => covers));
    const nameless: string[] = [];
    let count = 0;
    for (const [file, source] of Object.entries(sources))
      for (const names of controlsIn(source)) {
        count += 1;
        const isTool = file.endsWith('ToolPalette.vue'); // they are compared with the list of tools below
        if (!isTool && !names.some((name) => covered.has(name))) nameless.push(`${file}: ${names.join(', ')}`);
      }
    expect(nameless).toEqual([]);
    expect(count).toBeGreaterThan(45);
  });

  it('explains every tool of the palette', () => {
    const covered = new Set(entries.flatMap(({ covers }) => covers));
    expect(allTools.filter((tool) => !covered.has(tool))).toEqual([]);
  });

  it('names no control that is gone', () => {
    const there = new Set(Object.values(sources).flatMap((source) => controlsIn(source).flat()));
    const elsewhere = new Set(['board', 'arena', 'console', 'console-input', ...allTools]); // no buttons
    const all = Object.values(sources).join('\n');
    const isThere = (name: string): boolean =>
      there.has(name) ||
      elsewhere.has(name) ||
      all.includes(`'${name}'`) ||
      all.includes(`\`${name.replace('*', '${')}`) ||
      all.includes(`'${name.replace(/^menu-/, '')}'`);
    // One of an entry's names is enough: labels that change with the state stand beside a `data-testid`.
    const gone = entries.filter(({ covers }) => covers.length > 0 && !covers.some(isThere));
    expect(gone.map(({ id }) => id)).toEqual([]);
  });

  it('has every entry once', () => {
    const ids = entries.map(({ id }) => id);
    expect(new Set(ids).size).toBe(ids.length);
  });

  it('puts the entries of features after those that they name, and all others at the end of their section', () => {
    const entry = (id: string, after?: string): HelpEntry => ({
      ...{ id, section: 'menu', icon: '', name: () => id, text: () => id, covers: [] },
      ...(after !== undefined && { after }),
    });
    const sections = guideSections([entry('second', 'first'), entry('first', 'panes'), entry('last', 'nothing')]);
    const ids = sections.find(({ id }) => id === 'menu')?.entries.map(({ id }) => id);
    expect(ids?.slice(-8)).toEqual(['panes', 'first', 'second', 'device-check', 'help', 'tour', 'stages', 'last']);
  });

  it('leaves no text empty, in any language, and says nothing in two of them alike', () => {
    for (const language of LANGUAGES)
      for (const [id, text] of Object.entries(contents[language].texts)) {
        expect(text.trim(), `${language} ${id}`).not.toBe('');
        const others = LANGUAGES.filter((other) => other !== language).map(
          (other) => (contents[other].texts as Readonly<Record<string, string>>)[id],
        );
        expect(others, `${language} ${id}`).not.toContain(text);
      }
  });

  it('leaves the same places open for values in every language', () => {
    for (const key of ['found', 'commands', 'insert', 'inserted'] as const)
      for (const language of LANGUAGES)
        expect(contents[language][key].match(/\{\w+\}/g), `${language} ${key}`).toEqual(de[key].match(/\{\w+\}/g));
  });

  it('spells German the Swiss way, and puts narrow spaces where French has them', () => {
    expect(JSON.stringify(de)).not.toContain('ß');
    expect(JSON.stringify(fr).match(/ [;:?!»]|« /g)).toBeNull();
  });

  it('shows keys for every shortcut', () => {
    const shortcuts = entries.filter(({ id }) => id.startsWith('key-'));
    expect(shortcuts.length).toBeGreaterThan(20);
    for (const { id, keys } of shortcuts) expect(keys?.length, id).toBeGreaterThan(0);
  });
});

describe('the tour', () => {
  it('has at most eight steps, each but once, and begins with the program', () => {
    for (const hasArena of [true, false]) {
      const steps = stepsFor(hasArena);
      expect(steps.length).toBeLessThanOrEqual(8);
      expect(new Set(steps.map(({ id }) => id)).size).toBe(steps.length);
      expect(steps[0]?.id).toBe('code');
    }
    expect(stepsFor(false).some(({ pane }) => pane === 'arena')).toBe(false);
  });

  it('points at controls that exist', () => {
    const all = Object.values(sources).join('\n');
    const editors = '"editor" "arena" "console"'; // the panes' own contents
    for (const { targets } of [...stepsFor(true), ...stepsFor(false), { targets: [MENU] }])
      for (const selector of targets) {
        const name = /data-testid=("[^"]+")/.exec(selector)?.[1] ?? selector.replace('.', '');
        expect(all.includes(`data-testid=${name}`) || all.includes(name) || editors.includes(name), selector).toBe(
          true,
        );
      }
  });
});
