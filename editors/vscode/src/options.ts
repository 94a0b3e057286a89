// SPDX-License-Identifier: Apache-2.0
// What the extension starts and shows, as plain functions: they know nothing of VS Code, so that node tests them.

/** A program and its arguments. */
export interface Program {
    readonly command: string;
    readonly args: readonly string[];
}

/** A position and a location as they stand in the arguments of a code lens. */
export interface PlacesArguments {
    readonly uri: string;
    readonly position: { readonly line: number; readonly character: number };
    readonly places: readonly PlaceOf[];
}

export interface PlaceOf {
    readonly uri: string;
    readonly range: {
        readonly start: { readonly line: number; readonly character: number };
        readonly end: { readonly line: number; readonly character: number };
    };
}

/** What is started: the settings' words, then `lsp` and the settings' options. Words that are no text are left out. */
export function program(command: unknown, options: unknown): Program {
    const words = texts(command).filter((word) => word !== "");
    const [first, ...rest] = words.length > 0 ? words : ["rosward"];
    return { command: first as string, args: [...rest, "lsp", ...texts(options)] };
}

function texts(value: unknown): string[] {
    return Array.isArray(value) ? value.filter((word): word is string => typeof word === "string") : [];
}

/** The files of which the server is told: only those on the disk. */
export const SELECTOR: readonly { scheme: string; language?: string; pattern?: string }[] = [
    ...["python", "cpp", "c", "xml", "yaml"].map((language) => ({ scheme: "file", language })),
    { scheme: "file", pattern: "**/*.launch" },
];

/** The line of the status bar. */
export function status(busy: ReadonlyMap<string, boolean>): string {
    return [...busy.values()].some((each) => each) ? "$(sync~spin) rosward" : "$(check) rosward";
}

/** The arguments of a code lens; undefined where they are not what the server sends. */
export function places(args: readonly unknown[]): PlacesArguments | undefined {
    const [uri, position, found] = args;
    if (typeof uri !== "string" || !isPosition(position) || !Array.isArray(found) || !found.every(isPlace)) {
        return undefined;
    }
    return { uri, position, places: found };
}

function isPosition(value: unknown): value is { line: number; character: number } {
    const each = value as { line?: unknown; character?: unknown } | null;
    return typeof each === "object" && each !== null && isCount(each.line) && isCount(each.character);
}

function isCount(value: unknown): boolean {
    return Number.isInteger(value) && (value as number) >= 0;
}

function isPlace(value: unknown): value is PlaceOf {
    const each = value as { uri?: unknown; range?: { start?: unknown; end?: unknown } } | null;
    return (
        typeof each === "object" &&
        each !== null &&
        typeof each.uri === "string" &&
        typeof each.range === "object" &&
        each.range !== null &&
        isPosition(each.range.start) &&
        isPosition(each.range.end)
    );
}

/** What is said where the program does not start. */
export function missing(started: Program, reason: string): string {
    return (
        `rosward: cannot start '${[started.command, ...started.args].join(" ")}' (${reason}). ` +
        "Install it with: pip install 'rosward[lsp]', or set rosward.command."
    );
}
