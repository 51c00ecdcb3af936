//! The version of i_overlay that Cargo.lock names, for the driver to report.
fn main() {
    println!("cargo:rerun-if-changed=Cargo.lock");
    let lock = std::fs::read_to_string("Cargo.lock").unwrap_or_default();
    let version = lock
        .split("[[package]]")
        .find(|package| package.contains("name = \"i_overlay\""))
        .and_then(|package| package.split("version = \"").nth(1)?.split('"').next().map(str::to_string))
        .unwrap_or_else(|| "unknown".to_string());
    println!("cargo:rustc-env=IOVERLAY_VERSION={version}");
}
