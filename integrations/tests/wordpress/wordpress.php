<?php
/**
 * WordPress's own hooks, blocks, shortcodes and escaping, with a stand-in for what takes a database, users or WordPress 6.5.
 *
 *   php wordpress.php WORDPRESS PLUGIN.php STATE.json   reads { post, address, version, may, media } and prints the page
 *
 * A state with `upload` stands for a request of the media library's: it prints what the plugin keeps of that.
 */

list( , $folder, $plugin, $file ) = $argv;
define( 'ABSPATH', "$folder/" );
define( 'WPINC', 'wp-includes' );

$state   = json_decode( file_get_contents( $file ), true );
$modules = array();
$wanted  = array();

foreach (
	array(
		'compat', 'plugin', 'load', 'class-wp-object-cache', 'cache', 'functions', 'formatting', 'kses', 'shortcodes', 'rest-api', 'pomo/translations', 'l10n', 'class-wp-block-parser', 'class-wp-block-type',
		'class-wp-block-type-registry', 'class-wp-block-supports', 'block-supports/generated-classname', 'class-wp-block', 'class-wp-block-list', 'blocks',
	) as $part
) {
	require_once ABSPATH . WPINC . "/$part.php";
}
add_filter( 'the_content', 'do_blocks', 9 );
add_filter( 'the_content', 'wptexturize' );
add_filter( 'the_content', 'wpautop' );
add_filter( 'the_content', 'shortcode_unautop' );
add_filter( 'the_content', 'do_shortcode', 11 );
// Of a plugin that shows its readers what no reader should see.
add_shortcode( 'members', function () { return 'MEMBERS ONLY'; } );

wp_cache_init();
wp_cache_set( 'alloptions', array( 'blog_charset' => 'UTF-8' ), 'options' );
add_filter( 'pre_option', function ( $pre, $name ) { return $name === 'blog_charset' ? 'UTF-8' : ''; }, 10, 2 );
function get_bloginfo( $what ) { global $state; return $what === 'version' ? $state['version'] : ''; }
function current_user_can( $what, $post = null ) { global $state; return in_array( $post === null ? $what : "$what $post", $state['may'], true ); }
function plugins_url( $path, $plugin ) { global $state; return $state['address'] . 'wp-content/plugins/' . basename( dirname( $plugin ) ) . '/' . $path; }
add_filter( 'rest_url', function ( $url, $path ) { global $state; return $state['address'] . 'wp-json' . $path; }, 10, 2 );
function get_home_url() { global $state; return $state['address']; }
function wp_create_nonce( $for ) { return 'nonce-' . $for; }
function wp_register_script() { return true; }
function get_theme_file_path() { return '/none'; }

if ( version_compare( $state['version'], '6.5', '>=' ) ) {
	function wp_register_script_module( $id, $source, $needs, $version ) { global $modules; $modules[ $id ] = array( "$source?ver=$version", $needs ); }
	function wp_enqueue_script_module( $id ) { global $wanted; $wanted[ $id ] = true; }
}

/** The post that is shown has the number 7; pictures have numbers from 100, in the order of `media`. */
function get_the_ID() { return 7; }
function get_post_meta( $post, $key, $single ) {
	global $state;
	$number = array_search( $key, array_keys( $state['media'] ), true );
	return $post === 7 && $number !== false ? (string) ( 100 + $number ) : '';
}
function update_post_meta( $post, $key, $value ) { echo json_encode( array( $post, $key, $value ) ); }
/** A picture that has been deleted is null. */
function wp_attachment_is_image( $id ) { global $state; return array_values( $state['media'] )[ $id - 100 ] !== null; }
function wp_get_attachment_image( $id, $size, $icon, $more ) {
	global $state;
	list( $address, $width, $height, $alt ) = array_values( $state['media'] )[ $id - 100 ];
	$html = sprintf( '<img width="%d" height="%d" src="%s" class="attachment-large"', $width, $height, esc_url( $address ) );
	foreach ( $more + array( 'alt' => $alt ) as $name => $value ) { $html .= sprintf( ' %s="%s"', $name, esc_attr( $value ) ); }
	return "$html />";
}

require $plugin;

if ( isset( $state['upload'] ) ) {
	list( $id, $parent, $request ) = $state['upload'];
	do_action( 'rest_insert_attachment', (object) array( 'ID' => $id, 'post_parent' => $parent ), $request, true );
	exit;
}
do_action( 'init' );
ob_start();
do_action( 'admin_notices' );
$notices = ob_get_clean();
$post    = apply_filters( 'the_content', $state['post'] );
?>
<!doctype html>
<html lang="en">
<head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>Thursday maps</title>
<link rel="stylesheet" href="<?php echo $state['address']; ?>example.css"><link rel="icon" href="data:,"></head>
<body><?php echo $notices; ?><header>Thursday maps, by WordPress</header>
<main><h1>Two rivers before lunch</h1>
<?php echo $post; ?>
</main>
<?php
foreach ( array_keys( $wanted ) as $id ) { printf( "<script type=\"module\" src=\"%s\"></script>\n", $modules[ $id ][0] ); }
?>
</body></html>
