/**
 * What spreadsheets write for a value that could not be computed, in the languages that translate it. Such a cell is a
 * gap; a line that begins with one is a row, not a comment.
 */
const ERRORS =
  /^#(?:N\/?A|NV|N\/D|ND|NB|I\/T|NUL{1,2}[!]?|NULO!|NULL!|NULLA!|NULLPUNKT!|DIV\/?0!?|DEEL\/0!|D[IE]L\/0!|VALUE!|WERT!|VALEUR!|VALOR!|VALORE!|WAARDE!|VÄRDE(?:FEL)?!|VERDI!|VÆRDI!|ARVO!|HODNOTA!|ARG!|ÉRTÉK!|ЗНАЧ!|REF!|BEZUG!|RIF!|VERW!|ADR!|ODKAZ!|HIV!|ССЫЛКА!|NAME\?|NOM\?|NOMBRE\?|NOME\?|NAAM\?|NAMN\?|NAVN\??|NIMI\?|NÁZEV\?|NAZWA\?|NÉV\?|ИМЯ\?|ERROR_DEL_TIPO|¿NOMBRE\?|NUM!|ZAHL!|NOMBRE!|NÚM!|GETAL!|LICZBA!|TAL!|OGILTIGT!|SZÁM!|ČÍSLO!|ЧИСЛО!|LUKU!|SPILL!|CALC!|GETTING_DATA|FIELD!|BLOCKED!|CONNECT!|BUSY!|UNKNOWN!|ÜBERLAUF!|ERROR!|Н\/Д|ДЕЛ\/0!|ПУСТО!|PUUTTUU!?)$/i;

/** In any language: capitals at once behind the mark, and an exclamation or question mark; some have none. */
const ANY_ERROR = /^#[¡¿]?\p{Lu}[\p{Lu}\d_. ]*(?:\/[\p{Lu}\d]+)?[!?]$|^#(?:YOK|HIÁNYZIK|NENÍ_K_DISPOZICI|NEDOSTUPNÝ)$/u;

export function isSpreadsheetError(cell: string): boolean {
  return cell.charCodeAt(0) === 35 && cell.length <= 20 && (ERRORS.test(cell) || ANY_ERROR.test(cell));
}

/** Whether a line that begins with `#` begins with such a cell. */
export function beginsWithError(line: string): boolean {
  return isSpreadsheetError(/^[^,;\t|"]*/.exec(line.slice(0, 40))![0].trim());
}

/** Cells that say "nothing measured here". */
const MISSING =
  /^(?:|-|–|—|\.|[+-]?nan(?:\(.*\))?|-?1\.#(?:qnan|ind|snan)\d*|na|n\/a|n\.a\.|null|none|nil|missing|--+|\\n|\?)$/i;

/** Text that stands for a missing value: costs nothing where the column is not needed. */
export function isMissing(cell: string): boolean {
  const text = cell.trim();
  return text.length <= 20 && (MISSING.test(text) || isSpreadsheetError(text));
}
