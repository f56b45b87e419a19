<?php
/**
 * A stand-in for WordPress: what the plugin calls, as WordPress 6.5 answers, and nothing else.
 *
 *   php wordpress.php PLUGIN.php STATE.json   reads { post, address, version, may, media } and prints the page
 */

define( 'ABSPATH', __DIR__ . '/' );

$state      = json_decode( file_get_contents( $argv[2] ), true );
$actions    = array();
$shortcodes = array();
$blocks     = array();
$modules    = array();
$wanted     = array();

function add_action( $name, $call ) { global $actions; $actions[ $name ][] = $call; }
function do_action( $name ) { global $actions; foreach ( $actions[ $name ] ?? array() as $call ) { $call(); } }
function get_bloginfo( $what ) { global $state; return $what === 'version' ? $state['version'] : ''; }
function current_user_can( $what ) { global $state; return in_array( $what, $state['may'], true ); }
function plugins_url( $path, $plugin ) { global $state; return $state['address'] . 'wp-content/plugins/' . basename( dirname( $plugin ) ) . '/' . $path; }
function rest_url( $path ) { global $state; return $state['address'] . 'wp-json/' . $path; }
function wp_create_nonce( $for ) { return 'nonce-' . $for; }

// As in WordPress, what looks escaped is not escaped again.
function esc_attr( $text ) { return htmlspecialchars( $text, ENT_QUOTES, 'UTF-8', false ); }
function esc_html( $text ) { return htmlspecialchars( $text, ENT_QUOTES, 'UTF-8', false ); }
function esc_url( $text ) { return esc_attr( $text ); }
function wp_specialchars_decode( $text, $quotes ) { return htmlspecialchars_decode( $text, $quotes ); }

function add_shortcode( $name, $call ) { global $shortcodes; $shortcodes[ $name ] = $call; }
function shortcode_atts( $known, $given, $name ) { return array_merge( $known, array_intersect_key( (array) $given, $known ) ); }
function has_shortcode( $text, $name ) { return strpos( $text, "[$name" ) !== false; }
function do_shortcode( $text ) {
	$one = '/\[river-seed((?:\s+[a-z]+=(?:"[^"]*"|\'[^\']*\'))*)\s*\/?\](?:(.*?)\[\/river-seed\])?/s';
	return preg_replace_callback( $one, function ( $found ) {
		global $shortcodes;
		preg_match_all( '/([a-z]+)=(?:"([^"]*)"|\'([^\']*)\')/', $found[1], $all, PREG_SET_ORDER );
		$given = array();
		// As in WordPress, backslashes are lost.
		foreach ( $all as $each ) { $given[ $each[1] ] = stripcslashes( $each[3] ?? $each[2] ); }
		return $shortcodes['river-seed']( $given, $found[2] ?? null );
	}, $text );
}

function register_block_type( $folder, $more ) {
	global $blocks;
	$block = json_decode( file_get_contents( "$folder/block.json" ), true );
	$blocks[ $block['name'] ] = $more + $block;
}
function get_block_wrapper_attributes() { return 'class="wp-block-river-seed-map"'; }
function do_blocks( $text ) {
	return preg_replace_callback( '/<!-- wp:river-seed\/map (\{.*?\}) \/-->/', function ( $found ) {
		global $blocks;
		$block  = $blocks['river-seed/map'];
		$values = array_map( function ( $one ) { return $one['default']; }, $block['attributes'] );
		return $block['render_callback']( array_merge( $values, json_decode( $found[1], true ) ) );
	}, $text );
}

if ( version_compare( $state['version'], '6.5', '>=' ) ) {
	function wp_register_script_module( $id, $source, $needs, $version ) { global $modules; $modules[ $id ] = array( "$source?ver=$version", $needs ); }
	function wp_enqueue_script_module( $id ) { global $wanted; $wanted[ $id ] = true; }
}

function get_posts( $query ) {
	global $state;
	$is_asked = $query['post_type'] === 'attachment' && $query['post_status'] === 'inherit' && $query['fields'] === 'ids';
	return $is_asked && isset( $state['media'][ $query['name'] ] ) ? array( $query['name'] ) : array();
}
function wp_get_attachment_image( $id, $size, $icon, $more ) {
	global $state;
	list( $address, $width, $height ) = $state['media'][ $id ];
	$html = sprintf( '<img width="%d" height="%d" src="%s" class="attachment-large"', $width, $height, esc_url( $address ) );
	foreach ( $more as $name => $value ) { $html .= sprintf( ' %s="%s"', $name, esc_attr( $value ) ); }
	return "$html />";
}

require $argv[1];

do_action( 'init' );
ob_start();
do_action( 'admin_notices' );
$notices = ob_get_clean();
$post    = do_shortcode( do_blocks( $state['post'] ) );
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
