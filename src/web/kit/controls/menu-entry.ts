/** An entry of a menu; `act` gets what its menu hands to all entries. */
export interface MenuEntry<Host = void> {
  /** Tells the entry from the others of its list. */
  readonly id: string | number;
  readonly testId?: string | undefined;
  readonly icon?: string;
  /** An icon at the end. Left out: the sign of an entry that is folded. */
  readonly endIcon?: string;
  readonly title: string;
  /** Words below the title. */
  readonly about?: string | undefined;
  /** An entry that is chosen or ticked: `radio` is one of several. */
  readonly choice?: 'radio' | 'checkbox';
  readonly isChosen?: boolean;
  /** True if the entry stands out. Left out: if it is the chosen one of several. */
  readonly isActive?: boolean;
  /** The present choice, at the end of an entry that leads to the choice. */
  readonly value?: string | undefined;
  /** An entry that shows others in the menu's place, which stays open. */
  readonly leads?: true;
  /** An entry that unfolds others below it: true if it has. */
  readonly isUnfolded?: boolean;
  readonly isDisabled?: boolean | undefined;
  /** Its shortcut, such as `Ctrl+D`, which stands behind the title. */
  readonly keys?: string | undefined;
  /** The language of the title, if it is another than the page's. */
  readonly lang?: string;
  /** The menu stays open. */
  readonly stays?: boolean;
  readonly act: (host: Host) => void;
}
