/** A text in every language of the app that robots and parts speak; German in Swiss spelling. */
export interface Texts {
  readonly de: string;
  readonly en: string;
}
