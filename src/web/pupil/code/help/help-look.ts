import { EditorView } from '@codemirror/view';

/** How suggestions, cards and hints look, in the page's own colours. */
export const helpLook = EditorView.theme({
  '.cm-tooltip': {
    border: '1px solid var(--line)',
    borderRadius: 'var(--r-m)',
    backgroundColor: 'var(--surface)',
    color: 'var(--text)',
    boxShadow: 'var(--e3)',
    zIndex: '60',
  },
  '.cm-tooltip.cm-tooltip-hover, .cm-tooltip.cm-tooltip-above': { maxWidth: 'min(440px, calc(100vw - 24px))' },
  '.cm-helpCard': { padding: '8px 12px', font: '14px/20px var(--sans)', maxWidth: 'min(440px, calc(100vw - 24px))' },
  '.cm-helpCall': {
    font: '13px/19px var(--mono)',
    overflowWrap: 'anywhere',
    textIndent: '-1.2em',
    paddingLeft: '1.2em',
  },
  '.cm-helpName': { color: 'var(--c-fn)', fontWeight: '600' },
  '.cm-helpParameter': { background: 'none', color: 'inherit', whiteSpace: 'nowrap' },
  'mark.cm-helpParameter': {
    backgroundColor: 'var(--accent-soft)',
    color: 'var(--text)',
    borderRadius: '4px',
    boxShadow: '0 0 0 2px var(--accent-soft)',
    fontWeight: '700',
  },
  '.cm-helpType': { color: 'var(--text-3)', fontWeight: '400' },
  'mark .cm-helpType': { color: 'var(--text-2)' },
  '.cm-helpText': { margin: '6px 0 0', color: 'var(--text)' },
  '.cm-helpMissing': { margin: '6px 0 0', color: 'var(--warn)', fontWeight: '600' },
  '.cm-helpCaption': { marginTop: '4px', fontSize: '12px', lineHeight: '16px', color: 'var(--text-3)' },
  '.cm-helpHint': { padding: '4px 10px' },

  '.cm-tooltip.cm-tooltip-autocomplete': { padding: '4px' },
  '.cm-tooltip.cm-tooltip-autocomplete > ul': {
    font: '13px/20px var(--mono)',
    maxHeight: '262px',
    minWidth: '200px',
    maxWidth: 'min(420px, calc(100vw - 24px))',
  },
  '.cm-tooltip.cm-tooltip-autocomplete > ul > li': {
    display: 'flex',
    alignItems: 'baseline',
    gap: '6px',
    padding: '4px 8px',
    borderRadius: 'var(--r-s)',
    minHeight: '28px',
  },
  '.cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]': {
    backgroundColor: 'var(--accent-soft)',
    color: 'var(--text)',
  },
  '.cm-helpSign': { width: '1.2em', flex: 'none', textAlign: 'center', color: 'var(--text-3)' },
  '.cm-helpOption-function .cm-helpSign, .cm-helpOption-type .cm-helpSign': { color: 'var(--c-fn)' },
  '.cm-helpOption-value .cm-helpSign, .cm-helpOption-variable .cm-helpSign': { color: 'var(--c-num)' },
  '.cm-helpOption-keyword .cm-helpSign': { color: 'var(--c-kw)' },
  '.cm-completionLabel': { flex: 'none' },
  '.cm-completionMatchedText': { textDecoration: 'none', fontWeight: '700', color: 'var(--accent)' },
  '.cm-completionDetail': {
    marginLeft: 'auto',
    paddingLeft: '12px',
    fontStyle: 'normal',
    color: 'var(--text-3)',
    overflow: 'hidden',
    textOverflow: 'ellipsis',
    whiteSpace: 'nowrap',
  },
  'li[aria-selected] .cm-completionDetail, li[aria-selected] .cm-helpSign': { color: 'var(--text-2)' },
  // Without room beside the list, its card goes below it: both must fit above an on-screen keyboard.
  '@media (max-width: 599px)': {
    '.cm-tooltip.cm-tooltip-autocomplete > ul': { maxHeight: '170px' },
  },
  '.cm-tooltip.cm-completionInfo': { padding: '0', width: 'max-content', maxWidth: '360px', margin: '0 4px' },

  '.cm-panels': { backgroundColor: 'var(--surface-2)', color: 'var(--text)' },
  '.cm-panels.cm-panels-bottom': { borderTop: '1px solid var(--line)' },
  '.cm-helpBar': { display: 'flex', alignItems: 'flex-start', maxHeight: '40vh', overflowY: 'auto' },
  '.cm-helpBar .cm-helpCard': { flex: '1', maxWidth: 'none' },
  '.cm-helpClose': {
    flex: 'none',
    width: 'var(--hit)',
    height: 'var(--hit)',
    border: 'none',
    background: 'none',
    color: 'var(--text-2)',
    fontSize: '22px',
    cursor: 'pointer',
  },
  // A finger needs more room.
  '@media (pointer: coarse)': {
    '.cm-tooltip.cm-tooltip-autocomplete > ul > li': { minHeight: '40px', alignItems: 'center' },
  },
});
