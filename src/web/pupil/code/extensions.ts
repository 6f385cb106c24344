import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import { pythonLanguage } from '@codemirror/lang-python';
import {
  bracketMatching,
  HighlightStyle,
  indentOnInput,
  indentUnit,
  LanguageSupport,
  syntaxHighlighting,
} from '@codemirror/language';
import { EditorState, type Extension } from '@codemirror/state';
import {
  dropCursor,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  highlightSpecialChars,
  keymap,
  tooltips,
} from '@codemirror/view';
import { tags } from '@lezer/highlight';

import { deviceMarks } from './device-marks';
import type { DeviceMarksOptions } from './device-question';
import type { HelpOptions } from './help/help-options';
import { helpSlot } from './help-slot';
import { changedLines, wrongLines } from './line-marks';
import { wrappedLines } from './wrapped-lines';

/** Colours come from the page's variables, so one style serves light and dark. */
const colours = HighlightStyle.define([
  { tag: [tags.keyword, tags.operatorKeyword, tags.modifier], color: 'var(--c-kw)', fontWeight: '600' },
  { tag: [tags.string, tags.special(tags.string)], color: 'var(--c-str)' },
  { tag: tags.comment, color: 'var(--c-com)', fontStyle: 'italic' },
  { tag: [tags.number, tags.bool, tags.null, tags.self], color: 'var(--c-num)' },
  {
    tag: [
      tags.function(tags.variableName),
      tags.function(tags.propertyName),
      tags.function(tags.definition(tags.variableName)),
    ],
    color: 'var(--c-fn)',
  },
  { tag: [tags.className, tags.meta], color: 'var(--c-fn)' },
  { tag: tags.invalid, color: 'var(--stop)' },
]);

const look = EditorView.theme({
  '&': { height: '100%', backgroundColor: 'transparent', color: 'var(--text)', fontSize: 'var(--code)' },
  '&.cm-focused': { outline: 'none' },
  '.cm-scroller': { fontFamily: 'var(--mono)', lineHeight: 'var(--code-line)', overscrollBehavior: 'contain' },
  '.cm-content': { padding: '8px 0 16px', caretColor: 'var(--text)' },
  '.cm-line': { padding: '0 8px 0 6px' },
  '.cm-gutters': { backgroundColor: 'var(--surface)', border: 'none', color: 'var(--gutter)', fontSize: '12.5px' },
  '.cm-lineNumbers .cm-gutterElement': { minWidth: '28px', padding: '0 8px 0 4px', cursor: 'pointer' },
  '.cm-activeLine': { backgroundColor: 'transparent' },
  '.cm-activeLineGutter': { backgroundColor: 'transparent' },
  '&.cm-focused .cm-activeLine, &.cm-focused .cm-activeLineGutter': { backgroundColor: 'var(--select)' },
  '&.cm-focused .cm-activeLineGutter': { boxShadow: 'inset 3px 0 0 var(--brand)' },
  '.cm-matchingBracket, &.cm-focused .cm-matchingBracket': {
    backgroundColor: 'var(--accent-soft)',
    outline: '1px solid var(--accent-line)',
  },
  '.cm-wrongLine, &.cm-focused .cm-activeLine.cm-wrongLine': {
    backgroundColor: 'var(--stop-soft)',
    boxShadow: 'inset 3px 0 0 var(--stop)',
  },
  '.cm-changedLine, &.cm-focused .cm-activeLine.cm-changedLine': {
    backgroundColor: 'var(--warn-soft)',
    boxShadow: 'inset 3px 0 0 var(--warn)',
  },
  '.cm-specialChar': { color: 'var(--stop)' },
});

/** The editor for Python: four spaces, Ctrl+Enter runs. */
export function editorExtensions(options: {
  label: string;
  help: HelpOptions;
  device: DeviceMarksOptions;
  /** The column of line numbers, and what it does. */
  lineNumbers: Extension;
  /** The container of lists and cards: outside the pane, which cuts off what leaves it. */
  popups: HTMLElement;
  /** The use of the Tab key. */
  tabKey: Extension;
  /** Extensions that a task adds. */
  kept: Extension;
  onChange(text: string): void;
  onRun(): void;
}): Extension {
  return [
    options.kept,
    options.lineNumbers,
    highlightActiveLine(),
    highlightActiveLineGutter(),
    highlightSpecialChars(),
    history(),
    dropCursor(),
    indentOnInput(),
    bracketMatching(),
    new LanguageSupport(pythonLanguage),
    syntaxHighlighting(colours),
    indentUnit.of('    '),
    EditorState.tabSize.of(4),
    changedLines.field,
    wrongLines.field,
    wrappedLines,
    tooltips({ parent: options.popups }),
    helpSlot(options.help),
    deviceMarks(options.device),
    look,
    EditorView.contentAttributes.of({
      'aria-label': options.label,
      tabindex: '0',
      spellcheck: 'false',
      autocapitalize: 'off',
      autocorrect: 'off',
    }),
    options.tabKey,
    keymap.of([
      { key: 'Mod-Enter', run: () => (options.onRun(), true), preventDefault: true, stopPropagation: true },
      ...defaultKeymap,
      ...historyKeymap,
    ]),
    EditorView.updateListener.of((update) => {
      if (update.docChanged) options.onChange(update.state.doc.toString());
    }),
  ];
}
