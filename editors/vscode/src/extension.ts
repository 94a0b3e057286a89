// SPDX-License-Identifier: Apache-2.0
// The extension: it starts `rosward lsp`, and shows what a code lens is about. All else is the server's.

import * as vscode from "vscode";
import { LanguageClient, type LanguageClientOptions, type ServerOptions } from "vscode-languageclient/node";
import { missing, places, program, SELECTOR, status } from "./options";

let client: LanguageClient | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
    const output = vscode.window.createOutputChannel("rosward");
    const bar = vscode.window.createStatusBarItem(vscode.StatusBarAlignment.Right, 10);
    bar.command = "rosward.showLog";
    bar.tooltip = "rosward: show the log";
    context.subscriptions.push(
        output,
        bar,
        vscode.commands.registerCommand("rosward.restart", () => start(output, bar)),
        vscode.commands.registerCommand("rosward.showLog", () => output.show()),
        vscode.commands.registerCommand("rosward.showPlaces", showPlaces),
        vscode.workspace.onDidChangeConfiguration(async (change) => {
            if (change.affectsConfiguration("rosward")) {
                await start(output, bar);
            }
        }),
        vscode.workspace.onDidGrantWorkspaceTrust(() => start(output, bar)),
        { dispose: () => void client?.stop() },
    );
    await start(output, bar);
}

export async function deactivate(): Promise<void> {
    await client?.stop();
}

async function start(output: vscode.OutputChannel, bar: vscode.StatusBarItem): Promise<void> {
    await client?.stop().catch(() => undefined);
    const settings = vscode.workspace.getConfiguration("rosward");
    const started = program(settings.get("command"), settings.get("arguments"));
    const server: ServerOptions = { command: started.command, args: [...started.args] };
    const wanted: LanguageClientOptions = {
        documentSelector: SELECTOR.map((each) => ({ ...each })),
        outputChannel: output,
        middleware: {
            provideCodeLenses: (document, token, next) =>
                vscode.workspace.getConfiguration("rosward").get("codeLens", true) ? next(document, token) : [],
        },
    };
    client = new LanguageClient("rosward", "rosward", server, wanted);
    const busy = new Map<string, boolean>();
    client.onNotification("rosward/analysed", (told: { folder: string; busy: boolean }) => {
        busy.set(told.folder, told.busy);
        bar.text = status(busy);
        bar.show();
    });
    try {
        await client.start();
    } catch (error) {
        const message = missing(started, error instanceof Error ? error.message : String(error));
        output.appendLine(message);
        void vscode.window.showErrorMessage(message);
    }
}

async function showPlaces(...args: unknown[]): Promise<void> {
    const found = places(args);
    if (found === undefined) {
        return;
    }
    const locations = found.places.map(
        (each) =>
            new vscode.Location(
                vscode.Uri.parse(each.uri),
                new vscode.Range(
                    each.range.start.line,
                    each.range.start.character,
                    each.range.end.line,
                    each.range.end.character,
                ),
            ),
    );
    const position = new vscode.Position(found.position.line, found.position.character);
    await vscode.commands.executeCommand(
        "editor.action.showReferences",
        vscode.Uri.parse(found.uri),
        position,
        locations,
    );
}
